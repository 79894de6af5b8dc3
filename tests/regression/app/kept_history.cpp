/// A run's history beside its checkpoint, as a user meets it: killed, torn, moved, of another run.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <fstream>
#include <random>

#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using test::bad_input;
using test::done;
using test::Outcome;
using test::read_text;
using testing::HasSubstr;
using Words = std::vector<std::string>;

class KeptHistory : public test::Commands {
 protected:
  std::string flag_case() {
    return test::write_text(folder_ / "flag.toml",
                            "[flag]\nmu = 1\nK_B = 0.1\ngamma = 1\n[dns]\nn_x = 4\ndt = 0.01\n"
                            "t_end = 1\n[dns.flag]\nn_y = 8\n[dns.initial]\nangle = 0.2\n"
                            "[dns.output]\nshape_interval = 0.1\ncheckpoint_interval = 0.02\n")
        .string();
  }
  std::string coupled_case(double t_end) {
    return test::write_text(
               folder_ / "coupled.toml",
               fmt::format("[flag]\nmu = 0.125\nK_B = 1e-4\ndamping = 0.02\n[flow]\nRe = 300\n"
                           "[dns]\nn_rho = 16\nn_theta = 32\nwall_spacing = 0.05\ndt = 0.01\n"
                           "t_end = {}\n[dns.initial]\nA = [0.05]\n[dns.probes]\ny = [1.5]\n"
                           "z = [0.1]\n[dns.output]\nshape_interval = 0.1\n"
                           "checkpoint_interval = 0.02\n",
                           t_end))
        .string();
  }
  void run_to_the_end(Words words, const std::string& folder, int ranks = 1) {
    words.insert(words.end(), {"--quiet", "--output", results(folder)});
    const Outcome outcome = ranks == 1 ? pennon(words) : pennon_on(ranks, words);
    ASSERT_EQ(outcome.status, done) << outcome.err;
  }
  std::string refusal(const Words& words) {
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, bad_input);
    return outcome.err;
  }
  std::string checkpoint_in(const std::string& folder) const {
    return results(folder) + "/checkpoint.h5";
  }
  fs::path records_in(const std::string& folder) const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(results(folder)))
      if (entry.path().extension() == ".rows") found.push_back(entry.path());
    EXPECT_EQ(found.size(), 1U) << folder;
    return found.empty() ? fs::path() : found.front();
  }
  void expect_same(const std::string& folder, const std::string& expected, int shapes) {
    EXPECT_EQ(read_text(results(folder) + "/history.csv"),
              read_text(results(expected) + "/history.csv"))
        << folder;
    const hdf5::Reader found(results(folder) + "/shapes.h5");
    const hdf5::Reader reference(results(expected) + "/shapes.h5");
    EXPECT_EQ(found.list("/shape_times"), reference.list("/shape_times")) << folder;
    for (int s = 0; s < shapes; ++s)
      for (const char* name : {"position", "v_z", "e_1"}) {
        const std::string array = fmt::format("/{}/{:06}", name, s);
        EXPECT_EQ(found.read(array).values, reference.read(array).values) << folder << array;
      }
  }

  // Starts the run in results(folder), or goes on with its checkpoint, and kills it so long after
  // it has left a new checkpoint. False where it came to its end before.
  bool kill_after(const Words& words, const std::string& folder, std::chrono::microseconds wait,
                  int ranks = 1) {
    Words all = words;
    all.insert(all.end(), {"--quiet", "--output", results(folder)});
    const fs::path checkpoint = checkpoint_in(folder);
    fs::file_time_type before{};
    if (fs::exists(checkpoint)) {
      all.insert(all.end(), {"--restart", checkpoint.string()});
      before = fs::last_write_time(checkpoint);
    }
    const pid_t child = ranks == 1 ? start_in_background(all) : start_in_background_on(ranks, all);
    int status = 0;
    const auto is_running = [&] { return waitpid(child, &status, WNOHANG) == 0; };
    std::error_code none_yet;
    while (is_running() &&
           (!fs::exists(checkpoint) || fs::last_write_time(checkpoint, none_yet) == before))
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(wait);
    // Of ranks, one: mpiexec ends the others.
    kill(ranks == 1 ? child : child_of(child), SIGKILL);
    if (waitpid(child, &status, 0) < 0) return false;
    return !WIFEXITED(status) || WEXITSTATUS(status) != done;
  }
  void expect_same_after_kills(const Words& words, int kills, int longest_ms, int ranks = 1) {
    std::mt19937 engine(7);
    std::uniform_int_distribution<int> wait(0, 1000 * longest_ms);
    int killed = 0;
    for (int k = 0; k < kills; ++k)
      killed += kill_after(words, "parts", std::chrono::microseconds(wait(engine)), ranks) ? 1 : 0;
    EXPECT_GE(killed, kills / 2) << "the run is too short to be killed so often";
    Words rest = words;
    rest.insert(rest.end(), {"--restart", checkpoint_in("parts")});
    if (fs::exists(results("parts") + "/summary.json")) return;
    ASSERT_NO_FATAL_FAILURE(run_to_the_end(rest, "parts", ranks));
  }
};

TEST_F(KeptHistory, OfAFlowThatIsKilledAtAnyMomentIsTheSame) {
  const Words words = {"dns", coupled_case(3)};
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "whole"));
  ASSERT_NO_FATAL_FAILURE(expect_same_after_kills(words, 6, 40));
  expect_same("parts", "whole", 31);
  records_in("parts");  // one file
}

TEST_F(KeptHistory, OfAFlagThatIsKilledAtAnyMomentIsTheSame) {
  const Words words = {"dns", flag_case(), "--set", "dns.t_end=4"};
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "whole"));
  ASSERT_NO_FATAL_FAILURE(expect_same_after_kills(words, 6, 15));
  expect_same("parts", "whole", 41);
}

TEST_F(KeptHistory, OfTwoRanksThatAreKilledIsTheSame) {
  const std::string file = test::write_text(
      folder_ / "span.toml",
      "[flag]\nmu = 0.125\nK_B = 1e-4\ndamping = 0.02\ngamma = 2\n[flow]\nRe = 300\n[dns]\n"
      "n_x = 8\nn_rho = 16\nn_theta = 32\nwall_spacing = 0.05\ndt = 0.01\nt_end = 0.6\n"
      "[dns.initial]\nA = [0.01, 0.005]\n[dns.output]\nshape_interval = 0.1\n"
      "checkpoint_interval = 0.02\n");
  const Words words = {"dns", file};
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "whole", 2));
  ASSERT_NO_FATAL_FAILURE(expect_same_after_kills(words, 2, 40, 2));
  expect_same("parts", "whole", 7);
}

// A checkpoint at t = 0.5 of a run to t = 1, and what a restart makes of it.
class EarlyCheckpoint : public KeptHistory {
 protected:
  void SetUp() override {
    file_ = flag_case();
    ASSERT_NO_FATAL_FAILURE(run_to_the_end({"dns", file_}, "whole"));
    ASSERT_NO_FATAL_FAILURE(run_to_the_end({"dns", file_, "--set", "dns.t_end=0.5"}, "parts"));
    early_ = results("parts") + "/early.h5";
    fs::copy_file(checkpoint_in("parts"), early_);
  }
  Words restart() const { return {"dns", file_, "--restart", early_, "--quiet"}; }
  void go_on() { run_to_the_end({"dns", file_, "--restart", early_}, "parts"); }
  void append_to_records(const std::string& tail) {
    std::ofstream(records_in("parts"), std::ios::app | std::ios::binary) << tail;
  }

  std::string file_, early_;
};

TEST_F(EarlyCheckpoint, CutsATornTail) {
  const auto whole = fs::file_size(records_in("whole"));
  append_to_records(std::string(123, 'x'));
  ASSERT_NO_FATAL_FAILURE(go_on());
  expect_same("parts", "whole", 11);
  EXPECT_EQ(fs::file_size(records_in("parts")), whole);
}

TEST_F(EarlyCheckpoint, CutsRowsOfALaterTime) {
  ASSERT_NO_FATAL_FAILURE(go_on());
  ASSERT_NO_FATAL_FAILURE(go_on());  // once more from t = 0.5, with the rows up to 1 behind it
  expect_same("parts", "whole", 11);
  EXPECT_EQ(fs::file_size(records_in("parts")), fs::file_size(records_in("whole")));
  EXPECT_EQ(refusal({"dns", file_, "--restart", checkpoint_in("parts")}).find("is damaged"),
            std::string::npos);
}

TEST_F(EarlyCheckpoint, GoesOnInAnotherFolderAndLeavesItsOwn) {
  append_to_records("torn");
  const fs::path records = records_in("parts");
  const std::string before = read_text(records);
  ASSERT_NO_FATAL_FAILURE(run_to_the_end({"dns", file_, "--restart", early_}, "other"));
  expect_same("other", "whole", 11);
  EXPECT_NE(records_in("other").filename(), records.filename());
  EXPECT_EQ(fs::file_size(records_in("other")), fs::file_size(records_in("whole")));
  EXPECT_EQ(read_text(records), before);
  // And from there on.
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(
      {"dns", file_, "--set", "dns.t_end=1.2", "--restart", checkpoint_in("other")}, "other"));
}

TEST_F(EarlyCheckpoint, RefusesRecordsThatAreNotItsOwn) {
  const fs::path records = records_in("parts");
  const std::string whole = read_text(records);
  const auto say = [&] { return refusal(restart()); };
  fs::resize_file(records, whole.size() - 8);
  EXPECT_THAT(say(), testing::AllOf(HasSubstr(records.filename().string()), HasSubstr("was cut")));
  test::write_text(records, read_text(records_in("whole")));
  EXPECT_THAT(say(), HasSubstr("is another file"));
  std::string turned = whole;
  turned[turned.size() / 2] ^= 4;
  test::write_text(records, turned);
  EXPECT_THAT(say(), HasSubstr("is damaged"));
  fs::remove(records);
  EXPECT_THAT(say(), HasSubstr("there is no such file"));
  test::write_text(records, whole);
  ASSERT_NO_FATAL_FAILURE(go_on());
}

// Makes of a checkpoint one of format 1, which holds its history itself.
void make_earlier(const fs::path& checkpoint, const fs::path& run) {
  const hid_t file = H5Fopen(checkpoint.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
  std::string names = "/case\n/changes\n/history";
  for (const char* gone : {"/rows", "/arrays"}) ASSERT_GE(H5Ldelete(file, gone, H5P_DEFAULT), 0);
  const auto copy = [&](const char* from, const std::vector<const char*>& objects) {
    const hid_t source = H5Fopen((run / from).c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
    for (const char* object : objects)
      ASSERT_GE(H5Ocopy(source, object, file, object, H5P_DEFAULT, H5P_DEFAULT), 0) << object;
    H5Fclose(source);
  };
  copy("history.h5", {"/history", "/stations", "/trailing_edge", "/probes"});
  copy("shapes.h5", {"/shape_times", "/position", "/v_x", "/v_y", "/v_z", "/e_1"});
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, names.size());
  const hsize_t one = 1;
  const hid_t space = H5Screate_simple(1, &one, nullptr);
  const hid_t text =
      H5Dcreate2(file, "/arrays", type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
  ASSERT_GE(H5Dwrite(text, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, names.data()), 0);
  H5Dclose(text);
  H5Sclose(space);
  H5Tclose(type);
  ASSERT_GE(H5Fclose(file), 0);
}

TEST_F(KeptHistory, IsReadFromCheckpointsOfAnEarlierVersionToo) {
  const std::string file = coupled_case(0.5);
  ASSERT_NO_FATAL_FAILURE(run_to_the_end({"dns", file}, "first"));
  const Words words = {"dns", file, "--set", "dns.t_end=1", "--restart", checkpoint_in("first")};
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "now"));
  ASSERT_NO_FATAL_FAILURE(make_earlier(checkpoint_in("first"), results("first")));
  fs::remove(records_in("first"));
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "earlier"));
  expect_same("earlier", "now", 11);
  ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, "first"));  // in its own folder
  expect_same("first", "now", 11);
  EXPECT_EQ(fs::file_size(records_in("first")), fs::file_size(records_in("now")));
}

// --- Steps that take long

}  // namespace
}  // namespace pennon

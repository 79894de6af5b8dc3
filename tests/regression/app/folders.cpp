/// What a command finds in its folder: nothing of another command, case or run is lost.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "tests/support/commands.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bad_input;
using test::done;
using test::other;
using test::Outcome;
using test::read_text;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class Folders : public test::Commands {
 protected:
  // A flag by itself, of a few steps.
  std::string flag_case() {
    return test::write_text(folder_ / "case.toml",
                            "[flag]\nmu = 1\nK_B = 0.1\n[dns]\ndt = 0.01\nt_end = 0.2\n"
                            "[dns.flag]\nn_y = 11\n[dns.initial]\nangle = 0.2\n")
        .string();
  }
  Outcome run(std::vector<std::string> words, const std::vector<std::string>& more = {}) {
    words.insert(words.end(), more.begin(), more.end());
    return pennon(words);
  }
  std::string stability_case() {
    return test::write_text(folder_ / "flag.toml",
                            "[flag]\nmu = 0.125\n[flow]\nRe = 1000\n[modes.normal]\nm = 2\n")
        .string();
  }
};

TEST_F(Folders, OfEachCommandAreItsOwn) {
  const fs::path before = fs::current_path();
  fs::current_path(folder_.path());
  ASSERT_EQ(pennon({"lsa", stability_case(), "--quiet"}).status, done);
  ASSERT_EQ(pennon({"modes", stability_case(), "--quiet"}).status, done);
  fs::current_path(before);
  for (const char* name : {"lsa", "modes"})
    for (const char* file : {"case.resolved.toml", "summary.json", "record.json"})
      EXPECT_TRUE(fs::exists(folder_ / "results/flag" / name / file)) << name << file;
}

TEST_F(Folders, AreReplacedWholeByTheSameCaseAlone) {
  const std::vector<std::string> lsa = {"lsa", stability_case(), "--output", results()};
  ASSERT_EQ(run(lsa).status, done);
  ASSERT_EQ(run(lsa).status, done) << "the same again";
  const std::string summary = read_text(results() + "/summary.json");
  const Outcome another = run(lsa, {"--set", "flag.mu=0.03"});
  EXPECT_EQ(another.status, bad_input);
  EXPECT_THAT(another.err, AllOf(HasSubstr("holds results of another case: flag.mu = 0.125 there, "
                                           "0.03 here"),
                                 HasSubstr("--output"), HasSubstr("--force")));
  EXPECT_EQ(read_text(results() + "/summary.json"), summary) << "nothing was touched";
  EXPECT_EQ(run(lsa, {"--set", "flag.mu=0.03", "--force"}).status, done);
  EXPECT_NE(read_text(results() + "/summary.json"), summary);
}

TEST_F(Folders, OfAnotherCommandAreRefused) {
  ASSERT_EQ(pennon({"lsa", stability_case(), "--quiet", "--output", results()}).status, done);
  const Outcome outcome = pennon({"modes", stability_case(), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("holds results of pennon lsa"));
}

TEST_F(Folders, WithFilesThatPennonDidNotWriteAreRefused) {
  fs::create_directory(results());
  test::write_text(results() + "/history.csv", "mine");
  const std::vector<std::string> dns = {"dns", flag_case(), "--quiet", "--output", results()};
  const Outcome outcome = run(dns);
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("holds history.csv without the case"));
  EXPECT_EQ(read_text(results() + "/history.csv"), "mine");
  fs::rename(results() + "/history.csv", results() + "/notes.csv");
  EXPECT_EQ(run(dns).status, done) << "what is not of its names is left alone";
  EXPECT_EQ(read_text(results() + "/notes.csv"), "mine");
}

TEST_F(Folders, LoseTheFilesOfAnEarlierRunThatTheNextDoesNotWrite) {
  const std::vector<std::string> lsa = {"lsa", stability_case(), "--quiet", "--output", results()};
  ASSERT_EQ(run(lsa, {"--set", "lsa.curve.mu={from=0.01,to=1,points=5}"}).status, done);
  ASSERT_TRUE(fs::exists(results() + "/curve.csv"));
  ASSERT_EQ(run(lsa, {"--force"}).status, done);
  for (const auto& entry : fs::directory_iterator(results()))
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("curve")));
}

TEST_F(Folders, WithARunThatDidNotEndAreGoneOnWithOrForced) {
  const std::vector<std::string> dns = {"dns", flag_case(), "--quiet", "--output", results()};
  ASSERT_EQ(run(dns).status, done);
  const std::string whole = read_text(results() + "/history.csv");
  fs::remove(results() + "/summary.json");  // which comes last
  const Outcome again = run(dns);
  EXPECT_EQ(again.status, bad_input);
  EXPECT_THAT(again.err, HasSubstr("--restart " + results() + "/checkpoint.h5"));
  EXPECT_EQ(run(dns, {"--force"}).status, done);
  EXPECT_EQ(read_text(results() + "/history.csv"), whole);
}

TEST_F(Folders, GoOnToALaterEndAndRecordWhatChanges) {
  const std::vector<std::string> dns = {"dns", flag_case(), "--quiet", "--output", results()};
  ASSERT_EQ(run(dns).status, done);
  const std::vector<std::string> restart = {"--restart", results() + "/checkpoint.h5"};
  const auto go_on = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = restart;
    words.insert(words.end(), more.begin(), more.end());
    return run(dns, words);
  };
  const Outcome ended = go_on({});
  EXPECT_EQ(ended.status, bad_input);
  EXPECT_THAT(ended.err, HasSubstr("dns.t_end = 0.2 is reached already"));
  const Outcome lighter = go_on({"--set", "dns.t_end=0.3", "--set", "flag.mu=0.5"});
  EXPECT_EQ(lighter.status, bad_input);
  EXPECT_THAT(lighter.err,
              AllOf(HasSubstr("flag.mu = 1.0 there, 0.5 here"), HasSubstr("--change")));
  ASSERT_EQ(go_on({"--set", "dns.t_end=0.3", "--set", "dns.dt=0.02"}).status, done);
  ASSERT_EQ(go_on({"--set", "dns.t_end=0.4", "--set", "flag.mu=0.5", "--change"}).status, done);
  const json changes = json::parse(read_text(results() + "/record.json")).at("changes");
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].at("key"), "flag.mu");
  EXPECT_NEAR(changes[0].at("t"), 0.3, 1e-12);
  const std::string history = read_text(results() + "/history.csv");
  EXPECT_THAT(history, AllOf(HasSubstr("\n0.2,"), HasSubstr("\n0.22,"), HasSubstr("\n0.4,")));
}

TEST_F(Folders, SayWhatIsWrongWithARestart) {
  const std::string file = flag_case();
  const auto fault = [&](const std::vector<std::string>& more) {
    const Outcome outcome = run({"dns", file, "--output", results()}, more);
    EXPECT_EQ(outcome.status, bad_input) << outcome.err;
    EXPECT_FALSE(fs::exists(results())) << "nothing is written";
    return outcome.err;
  };
  EXPECT_THAT(fault({"--restart", ""}), HasSubstr("--restart: is empty"));
  EXPECT_THAT(fault({"--restart", "nofile.h5"}), HasSubstr("nofile.h5: there is no such file"));
  EXPECT_THAT(fault({"--change"}), HasSubstr("--change: is of a restart"));
}

TEST_F(Folders, AreWrittenToByOneProcessAtATime) {
  const std::vector<std::string> long_run = {"dns",   flag_case(),    "--set",    "dns.t_end=50",
                                             "--set", "dns.dt=0.001", "--output", results()};
  const pid_t child = start_in_background(long_run);
  while (!fs::exists(results() + "/case.resolved.toml"))
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const pid_t second =
      test::start_program({PENNON_EXECUTABLE, "dns", flag_case(), "--force", "--output", results()},
                          folder_ / "second_out.txt", folder_ / "second_err.txt");
  int status = 0;
  waitpid(second, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), bad_input);
  EXPECT_THAT(read_text(folder_ / "second_err.txt"),
              HasSubstr("is being written to by process " + std::to_string(child)));
  kill(child, SIGKILL);
  finish(child);
  EXPECT_EQ(pennon({"dns", flag_case(), "--quiet", "--force", "--output", results()}).status, done)
      << "what a killed process held is free";
  for (const auto& entry : fs::directory_iterator(results()))
    EXPECT_FALSE(entry.path().filename().string().starts_with(".")) << entry.path();
}

TEST_F(Folders, WithAPipeForACaseAreRefusedAtOnce) {
  fs::create_directory(results());
  ASSERT_EQ(mkfifo((results() + "/case.resolved.toml").c_str(), 0600), 0);
  const Outcome outcome = pennon({"lsa", stability_case(), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("case.resolved.toml: is not a regular file"));
}

TEST_F(Folders, OfACaseAreTakenByPlot) {
  ASSERT_EQ(pennon({"lsa", stability_case(), "--quiet", "--set",
                    "lsa.curve.mu={from=0.01,to=1,points=5}", "--output", results("case/lsa")})
                .status,
            done);
  fs::remove(results("case/lsa/curve.png"));
  const Outcome outcome = pennon({"plot", results("case")});
  EXPECT_EQ(outcome.status, done) << outcome.err;
  EXPECT_TRUE(fs::exists(results("case/lsa/curve.png")));
  EXPECT_EQ(pennon({"plot", (test::source / "data/cases").string()}).status, bad_input);
}

TEST_F(Folders, SayThatTheAnswerWasLost) {
  const pid_t child =
      test::start_program({PENNON_EXECUTABLE, "lsa", stability_case(), "--output", results()},
                          "/dev/full", folder_ / "err.txt");
  test::write_text(folder_ / "out.txt", "");
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.status, other);
  EXPECT_THAT(outcome.err, HasSubstr("cannot be written to standard output"));
  EXPECT_TRUE(fs::exists(results() + "/summary.json")) << "the results are there";
}

}  // namespace
}  // namespace pennon

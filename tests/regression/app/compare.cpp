/// pennon compare, as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "common/io/csv.hpp"
#include "tests/support/commands.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using test::bad_input;
using test::done;
using test::Outcome;
using testing::HasSubstr;
using testing::Not;

class Compare : public test::Commands {
 protected:
  std::string case_file(double mu, const std::string& more = "") {
    return test::write_text(
               folder_ / "case.toml",
               fmt::format("[flag]\nmu = {}\nK_B = 1e-3\ndamping = 0.02\n{}[flow]\nRe = 300\n"
                           "[dns]\nn_rho = 16\nn_theta = 32\nR = 4\nwall_spacing = 0.05\n"
                           "dt = 0.02\nt_end = 16\n[dns.initial]\nkick = 1e-5\nrelease = 4\n"
                           "[modes.global]\nn_modes = 2\ntarget = [0.4, 2.6]\n",
                           mu, more))
        .string();
  }
};

TEST_F(Compare, SetsLocalTheoryGlobalModesAndSimulationSideBySide) {
  const std::string file = case_file(0.3);
  ASSERT_EQ(pennon({"dns", file, "--quiet", "--output", results("run")}).status, done);
  const Outcome outcome =
      pennon({"compare", file, "--run", results("run"), "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json rows = json::parse(outcome.out).at("compare");
  ASSERT_EQ(rows.size(), 3u);
  const json &local = rows[0], &global = rows[1], &dns = rows[2];
  EXPECT_EQ(local.at("model"), "local");
  EXPECT_EQ(global.at("model"), "global");
  EXPECT_EQ(dns.at("model"), "dns");
  const json point =
      json::parse(pennon({"lsa", file, "--json", "--output", results("lsa")}).out).at("lsa");
  EXPECT_EQ(local.at("growth"), point.at("growth"));
  EXPECT_EQ(local.at("unstable"), point.at("unstable"));
  for (const json& row : {global, dns}) {
    EXPECT_EQ(row.at("waves"), 0);
    EXPECT_EQ(row.at("unstable"), true);
  }
  // The simulation grows as the global mode.
  const double growth = global.at("growth"), frequency = global.at("frequency");
  EXPECT_NEAR(dns.at("growth"), growth, 0.03 * growth);
  EXPECT_NEAR(dns.at("frequency"), frequency, 0.01 * frequency);
  EXPECT_GT(dns.at("wall_s"), 0);
  EXPECT_EQ(CsvTable(results() + "/compare.csv").rows(), 3u);
}

TEST_F(Compare, GoesOverTheWavesOfTheSpanAndSaysThatThereIsNoRun) {
  const std::string file = case_file(0.3, "gamma = 2\n");
  const Outcome outcome = pennon({"compare", file, "--set", "compare.waves=[1]", "--set",
                                  "modes.global.target=[-0.1, 2.8]", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("no simulation to compare with in results/case"));
  const json rows = json::parse(test::read_text(results() + "/summary.json")).at("compare");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[1].at("waves"), 1);
  EXPECT_EQ(rows[1].at("unstable"), false);
  const json problem = json::parse(test::read_text(results() + "/global_1/global_modes.json"));
  EXPECT_EQ(rows[1].at("growth"), problem.at("global").at("modes")[0].at("growth"));
}

TEST_F(Compare, TakesTheGlobalModesThatLieThereForTheSameProblem) {
  const std::string file = case_file(0.3);
  const auto compare = [&](const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = {"compare", file, "--output", results("all/compare")};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return outcome.out;
  };
  const auto growth = [&] {
    return json::parse(test::read_text(results("all/compare") + "/summary.json"))
        .at("compare")[1]
        .at("growth")
        .get<double>();
  };
  const auto uses = [&](const std::string& folder) {
    return HasSubstr("are those in " + results(folder));
  };
  const std::string modes = results("all/modes");
  ASSERT_EQ(pennon({"modes", file, "--quiet", "--output", modes}).status, done);
  EXPECT_THAT(compare(), uses("all/modes"));
  const json there = json::parse(test::read_text(modes + "/global_modes.json"));
  EXPECT_EQ(growth(), there.at("global").at("modes")[0].at("growth"));
  EXPECT_FALSE(std::filesystem::exists(results("all/compare/global_0/global_modes.json")));

  // Of another flag they are found, and are there for the next time.
  EXPECT_THAT(compare({"--force", "--set", "flag.K_B=2e-3"}), Not(HasSubstr("are those in")));
  const double of_other = growth();
  EXPECT_NE(of_other, there.at("global").at("modes")[0].at("growth"));
  EXPECT_THAT(compare({"--set", "flag.K_B=2e-3"}), uses("all/compare/global_0"));
  EXPECT_EQ(growth(), of_other);

  // Not of another version, nor damaged.
  const std::string problem = modes + "/global_problem.toml";
  const std::string text = test::read_text(problem);
  ASSERT_NE(text.find("pennon-global"), std::string::npos);
  test::write_text(problem,
                   "# What pennon-global 0.0 (older) solved.\n" + text.substr(text.find('\n') + 1));
  std::filesystem::remove_all(results("all/compare"));
  EXPECT_THAT(compare(), Not(HasSubstr("are those in")));
  std::filesystem::remove_all(results("all/compare"));
  test::write_text(problem, text);
  test::write_text(modes + "/global_modes.json", "{");
  EXPECT_THAT(compare(), Not(HasSubstr("are those in")));
}

// The modes of no wave are found before those of one.
TEST_F(Compare, GoesOnAfterAnInterruptWithTheModesThatItFound) {
  const std::string file = case_file(0.3, "gamma = 2\n");
  const std::vector<std::string> words = {"compare",  file,     "--set", "compare.waves=[0, 1]",
                                          "--output", results()};
  // The answer to another question must not stay beside a question without an answer.
  std::filesystem::create_directories(results() + "/global_1");
  test::write_text(results() + "/global_1/global_modes.json", "{}");
  const pid_t child = start_in_background(words);
  while (!std::filesystem::exists(results() + "/global_1/global_problem.toml") &&
         waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(child, SIGTERM);
  const Outcome stopped = finish(child);
  EXPECT_EQ(stopped.status, test::other);
  EXPECT_THAT(stopped.err, HasSubstr("stopped by SIGTERM; the global modes found before are kept"));
  EXPECT_FALSE(std::filesystem::exists(results() + "/global_1/global_modes.json"));
  const auto time_of_0 =
      std::filesystem::last_write_time(results() + "/global_0/global_modes.json");
  const Outcome outcome = pennon(words);
  ASSERT_EQ(outcome.status, done) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("with 0 waves along the span are those in"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("with 1 waves along the span are those in")));
  EXPECT_EQ(std::filesystem::last_write_time(results() + "/global_0/global_modes.json"), time_of_0);
}

TEST_F(Compare, RefusesTheRunOfAnotherFlag) {
  ASSERT_EQ(pennon({"dns", case_file(0.3), "--quiet", "--set", "dns.t_end=4.5", "--output",
                    results("run")})
                .status,
            done);
  const Outcome outcome =
      pennon({"compare", case_file(0.2), "--run", results("run"), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("flag.mu = 0.3 there, 0.2 here"));
}

TEST_F(Compare, RefusesWavesAlongASpanThatIsNotThere) {
  const Outcome outcome =
      pennon({"compare", case_file(0.3), "--set", "compare.waves=[0, 2]", "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("compare.waves counts waves along a span"));
}

}  // namespace
}  // namespace pennon

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

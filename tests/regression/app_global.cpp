/// pennon modes of a case with [modes.global], as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/csv.hpp"
#include "tests/support/commands.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using test::bad_input;
using test::done;
using test::Outcome;
using testing::HasSubstr;
using testing::StartsWith;

class ModesGlobal : public test::Commands {
 protected:
  std::string case_file(const std::string& modes, const std::string& flag = "") {
    return test::write_text(folder_ / "case.toml",
                            "[flag]\nmu = 0.3\nK_B = 1e-3\n" + flag +
                                "[flow]\nRe = 300\n[dns]\nn_rho = 16\nn_theta = 32\nR = 4\n"
                                "wall_spacing = 0.05\ndt = 0.02\n[modes.global]\n" +
                                modes)
        .string();
  }
};

TEST_F(ModesGlobal, PrintsAndWritesTheModesNextToATarget) {
  const std::string file = case_file("n_modes = 3\ntarget = [0.4, 2.6]\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json global = json::parse(outcome.out).at("global");
  EXPECT_EQ(global.at("requested"), 3);
  EXPECT_EQ(global.at("converged"), 3);
  const json& base = global.at("base_flow");
  EXPECT_NEAR(base.at("tension_leading_edge"), base.at("drag_coefficient").get<double>() / 2,
              1e-12);
  EXPECT_LT(base.at("residual"), 1e-8);
  ASSERT_EQ(global.at("modes").size(), 3u);
  for (const json& mode : global.at("modes")) {
    EXPECT_LT(mode.at("residual"), 1e-6);
    EXPECT_NEAR(mode.at("frequency"), mode.at("omega").get<double>() / (2 * M_PI), 1e-12);
  }
  EXPECT_GE(global.at("modes")[0].at("growth"), global.at("modes")[1].at("growth"));
  const CsvTable table(results() + "/global_modes.csv"), shapes(results() + "/global_shapes.csv");
  EXPECT_EQ(table.rows(), 3u);
  EXPECT_EQ(shapes.rows(), 3u * 17u);
  EXPECT_EQ(json::parse(test::read_text(results() + "/summary.json")).at("global"), global);
}

TEST_F(ModesGlobal, FindsTheLeadingModesWithoutATarget) {
  const std::string file = case_file("n_modes = 4\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json modes = json::parse(outcome.out).at("global").at("modes");
  ASSERT_EQ(modes.size(), 4u);
  EXPECT_NEAR(modes[0].at("growth"), 0.44, 0.03);
  EXPECT_NEAR(modes[0].at("omega"), 2.66, 0.1);
  for (std::size_t k = 1; k < modes.size(); ++k)
    EXPECT_LE(modes[k].at("growth"), modes[k - 1].at("growth"));
}

TEST_F(ModesGlobal, TakesTheWaveOfTheSpan) {
  const std::string file = case_file("n_modes = 1\ntarget = [-0.1, 2.8]\n", "gamma = 2\n");
  const Outcome wave = pennon({"modes", file, "--json", "--output", results()});
  ASSERT_EQ(wave.status, done) << wave.err;
  const Outcome same = pennon({"modes",
                               case_file("n_modes = 1\ntarget = [-0.1, 2.8]\nk_x = "
                                         "3.141592653589793\n"),
                               "--json", "--output", results("other")});
  ASSERT_EQ(same.status, done) << same.err;
  EXPECT_EQ(json::parse(wave.out).at("global"), json::parse(same.out).at("global"));
}

TEST_F(ModesGlobal, FindsTheNeutralCurveAndChecksItByTheFullOperator) {
  const std::string file = case_file(
      "n_modes = 0\n[modes.global.neutral]\nRe = [280, 300]\nmu = [0.02, 2]\nomega = [1, 10]\n"
      "[lsa]\nadded_mass = \"wu\"\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json global = json::parse(outcome.out).at("global");
  EXPECT_EQ(global.at("modes").size(), 0u);
  EXPECT_EQ(global.at("neutral_over"), "Re");
  EXPECT_TRUE(global.at("neutral_missing").empty());
  ASSERT_EQ(global.at("neutral").size(), 2u);
  for (const json& point : global.at("neutral")) {
    EXPECT_LT(point.at("residual"), 1e-6);
    EXPECT_EQ(point.at("mu_cr"), point.at("modes")[0].at("mu"));
    // The spectrum of the full operator at mu_cr has i omega in it, and nothing that grows.
    EXPECT_LT(point.at("distance"), 1e-7);
    EXPECT_LT(point.at("largest_growth"), 1e-7);
    EXPECT_GT(point.at("modes")[0].at("growth_by_mu"), 0);
  }
  EXPECT_GT(global.at("neutral")[0].at("mu_cr"), global.at("neutral")[1].at("mu_cr"));
  const CsvTable table(results() + "/global_neutral.csv");
  ASSERT_EQ(table.rows(), 2u);
  EXPECT_EQ(table.number(1, table.column("mu_cr")),
            global.at("neutral")[1].at("mu_cr").get<double>());
  EXPECT_GE(CsvTable(results() + "/global_neutral_branches.csv").rows(), 2u);
  EXPECT_TRUE(std::filesystem::exists(results() + "/global_neutral.png"));
}

TEST_F(ModesGlobal, MapsTheGrowthRateOfTheLeadingModeOfTheFullOperator) {
  const std::string file = case_file(
      "n_modes = 1\n[modes.global.map]\nmu = [0.2, 0.3]\nK_B = [1e-3, 2e-3]\nomega = [1, 10]\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json global = json::parse(outcome.out).at("global");
  EXPECT_EQ(global.at("map").at("points"), 4);
  EXPECT_LT(global.at("map").at("lambda_error"), 1e-3);
  const CsvTable table(results() + "/global_map.csv");
  ASSERT_EQ(table.rows(), 4u);
  constexpr std::size_t at_the_flag = 2;
  ASSERT_EQ(table.number(at_the_flag, table.column("mu")), 0.3);
  ASSERT_EQ(table.number(at_the_flag, table.column("K_B")), 1e-3);
  EXPECT_NEAR(*table.number(at_the_flag, table.column("growth")),
              global.at("modes")[0].at("growth").get<double>(), 1e-4);
  EXPECT_NEAR(*table.number(at_the_flag, table.column("omega")),
              global.at("modes")[0].at("omega").get<double>(), 1e-4);
  EXPECT_TRUE(std::filesystem::exists(results() + "/global_map.png"));
}

TEST_F(ModesGlobal, NamesWhatIsWrongWithANeutralCurve) {
  const Outcome outcome = pennon({"modes",
                                  case_file("[modes.global.neutral]\nRe = [300, 200]\nk_x = [0, "
                                            "1]\nmu = [2, 1]\nomega = [1]\n"),
                                  "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.neutral.Re must list its values in increasing"));
  EXPECT_THAT(outcome.err,
              HasSubstr("needs one of Re, k_x, K_B, nu_s as a range or a list; it has 2"));
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.neutral.mu = [2, 1] is empty"));
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.neutral.omega holds 1 numbers"));
}

TEST_F(ModesGlobal, NamesWhatIsWrongWithTheInput) {
  const Outcome outcome = pennon({"modes",
                                  case_file("target = [1]\nn_theta = 31\n",
                                            "gravity = "
                                            "[0, 1, 0]\n"),
                                  "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.target holds 1 numbers"));
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.n_theta = 31 must be even"));
  EXPECT_THAT(outcome.err, HasSubstr("does not know flag.gravity"));
}

TEST_F(ModesGlobal, PassesOnWhatItsProgramSays) {
  const Outcome outcome =
      pennon({"modes", case_file("wall_spacing = 1e-6\n"), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err,
              StartsWith("modes.global: no grid: dns.wall_spacing = 1e-06 does not reach"));
}

}  // namespace
}  // namespace pennon

/// pennon analyze on the folder of a run, as a user starts it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "analysis/signal/series.hpp"
#include "common/io/csv.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/synthetic_run.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bad_input;
using test::done;
using test::Outcome;
using test::two_pi;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double f = 0.85, sigma = 0.5, amplitude = 0.13, gamma_of_run = 2, U = 0.25;
constexpr double k_x = two_pi / gamma_of_run;
const double k_flag = k_x / std::tan(20 * std::numbers::pi / 180);
const double k_wake = two_pi * f - k_x * U;

// Stuart's and Landau's amplitude, from 1e-3 L.
double size_at(double t) {
  const double c = std::pow(amplitude / 1e-3, 2) - 1;
  return amplitude / std::sqrt(1 + c * std::exp(-2 * sigma * t));
}

double oblique(double k_y, double x, double y, double t) {
  return size_at(t) * std::cos(k_x * x + k_y * (y - 1) - two_pi * f * t);
}

class Analyze : public test::Commands {
 protected:
  // The folder of a run in which a wave grows, travels along the span and saturates.
  std::string oblique_run() {
    fs::create_directory(folder_ / "run");
    write_case("gamma = 2.0", "");
    analysis::RunHistory run =
        test::synthetic_run(test::unequal_times(24, 0.02), gamma_of_run, 8,
                            [](double x, double t) { return oblique(k_flag, x, 1, t); });
    test::set_column(run, "C_D", [](double t) { return 0.06 + size_at(t) / 10; });
    for (const double y : {2.0, 3.0})
      test::add_probe(
          run, y, 0.25, [](double, double) { return 0.0; },
          [y](double x, double t) { return oblique(k_wake, x, y, t); });
    test::write_history(run, folder_ / "run/history.h5");
    test::write_shapes(
        analysis::equal_times(0, 24, 241), gamma_of_run, 8, 21,
        [](double x, double y, double t) { return y * oblique(k_flag, x, y, t); },
        folder_ / "run/shapes.h5");
    return (folder_ / "run").string();
  }
  // That of a flag in two dimensions that flaps with one amplitude all the time.
  std::string steady_run(const std::string& kind = "coupled_history") {
    fs::create_directory(folder_ / "run");
    write_case("", "");
    analysis::RunHistory run =
        test::synthetic_run(test::unequal_times(12, 0.02), 1, 1,
                            [](double, double t) { return 0.1 * std::sin(two_pi * f * t); });
    test::set_column(run, "kinetic", [](double) { return 0.1; });
    test::write_history(run, folder_ / "run/history.h5", kind);
    return (folder_ / "run").string();
  }
  void write_case(const std::string& flag, const std::string& rest) {
    test::write_text(folder_ / "run/case.resolved.toml",
                     "[flag]\nmu = 0.125\n" + flag + "\n[flow]\nRe = 1000.0\nU = 0.25\n" + rest);
  }
};

TEST_F(Analyze, TellsTheNumbersOfAnObliqueWave) {
  const std::string run = oblique_run();
  const Outcome outcome = pennon({"analyze", run, "--json"});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  EXPECT_THAT(outcome.err, IsEmpty());
  const json found = json::parse(outcome.out).at("analyze");
  const json& cycle = found.at("limit_cycle");
  EXPECT_NEAR(cycle.at("A_over_L"), amplitude, 1e-3);
  EXPECT_NEAR(cycle.at("f_s"), f, 1e-3);
  EXPECT_NEAR(cycle.at("f_v"), f, 1e-3);
  EXPECT_NEAR(cycle.at("St"), 2 * amplitude * f, 1e-3);
  EXPECT_NEAR(cycle.at("C_D_mean"), 0.06 + amplitude / 10, 1e-4);
  EXPECT_NEAR(cycle.at("theta_s_deg"), 20, 0.2);
  EXPECT_NEAR(cycle.at("theta_v_deg"), std::atan(k_x / k_wake) * 180 / std::numbers::pi, 0.2);
  const json& growth = found.at("growth");
  EXPECT_NEAR(growth.at("sigma"), sigma, 0.02);
  EXPECT_NEAR(growth.at("omega"), two_pi * f, 0.02);
  EXPECT_EQ(growth.at("wave"), 1);
  const double c = std::pow(amplitude / 1e-3, 2) - 1;
  EXPECT_NEAR(found.at("phases").at("I_end"), std::log(c / 3) / (2 * sigma), 0.5 / f);
  EXPECT_NEAR(found.at("phases").at("II_end"), std::log(c / 0.2346) / (2 * sigma), 0.5 / f);
  EXPECT_THAT(found.at("notes"), IsEmpty());
}

TEST_F(Analyze, LeavesTablesAndPictures) {
  const std::string run = oblique_run();
  ASSERT_EQ(pennon({"analyze", run, "--quiet"}).status, done);
  for (const char* picture : {"trailing_edge", "growth", "spanwise_amplitudes", "waterfall",
                              "space_and_time", "forces", "flag_energy", "energy_budget"})
    for (const char* ending : {".png", ".svg"})
      EXPECT_TRUE(fs::exists(run + "/analysis/" + picture + ending)) << picture << ending;
  for (const char* file : {"summary.json", "record.json", "energy.csv"})
    EXPECT_TRUE(fs::exists(run + "/analysis/" + file)) << file;
  const CsvTable amplitudes(run + "/analysis/spanwise_amplitudes.csv");
  const std::size_t last = amplitudes.rows() - 1;
  EXPECT_NEAR(*amplitudes.number(last, amplitudes.column("zeta_1")), amplitude, 1e-3);
  EXPECT_NEAR(*amplitudes.number(last, amplitudes.column("zeta_0")), 0, 1e-12);
  EXPECT_EQ(CsvTable(run + "/analysis/limit_cycle.csv").rows(), 5U);
}

TEST_F(Analyze, GivesNullAndASentenceForWhatARunDoesNotTell) {
  const std::string run = steady_run();
  const Outcome outcome = pennon({"analyze", run, "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  for (const char* part : {"limit cycle over 5 periods: A/L = 0.1,", "growth: the trailing edge",
                           "no probe in the wake", "I_end: the run has half", "two dimensions"})
    EXPECT_THAT(outcome.out, HasSubstr(part));
  const json found = json::parse(test::read_text(results() + "/summary.json")).at("analyze");
  EXPECT_TRUE(found.at("growth").at("sigma").is_null());
  EXPECT_TRUE(found.at("limit_cycle").at("f_v").is_null());
  EXPECT_TRUE(found.at("phases").at("I_end").is_null());
  EXPECT_EQ(found.at("notes").size(), 4U);
  EXPECT_FALSE(fs::exists(run + "/analysis"));
}

TEST_F(Analyze, TakesTheWindowFromTheCommandLineOrTheCase) {
  const std::string run = oblique_run();
  const auto window = [&](const std::vector<std::string>& options) {
    std::vector<std::string> words = {"analyze", run, "--json", "--force"};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, done) << outcome.err;
    const json growth = json::parse(outcome.out).at("analyze").at("growth");
    return std::pair(growth.at("from").get<double>(), growth.at("to").get<double>());
  };
  EXPECT_EQ(window({"--from", "1", "--to", "6"}), std::pair(1.0, 6.0));
  write_case("gamma = 2.0", "[analysis]\nfrom = 0.5\nto = 5.0\n");
  EXPECT_EQ(window({}), std::pair(0.5, 5.0));
  EXPECT_EQ(window({"--to", "7"}), std::pair(0.5, 7.0));
}

TEST_F(Analyze, SaysWhatIsWrongWithTheFolder) {
  const auto fault = [&](const std::string& run, const std::vector<std::string>& options = {}) {
    std::vector<std::string> words = {"analyze", run};
    words.insert(words.end(), options.begin(), options.end());
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, bad_input);
    return outcome.err;
  };
  EXPECT_THAT(fault(results("none")), HasSubstr("none: there is no such folder"));
  EXPECT_THAT(fault(folder_.path().string()), HasSubstr("has no history.h5"));
  EXPECT_THAT(fault(steady_run("flag_history")), HasSubstr("holds flag_history"));
  const std::string run = steady_run();
  EXPECT_THAT(fault(run, {"--from", "8", "--to", "3"}), HasSubstr("the window from t = 8 to 3"));
  EXPECT_THAT(fault(run, {"--to", "300"}), HasSubstr("--to"));
  EXPECT_FALSE(fs::exists(run + "/analysis"));
  fs::remove(run + "/case.resolved.toml");
  EXPECT_THAT(fault(run), HasSubstr("case.resolved.toml"));
}

TEST_F(Analyze, HasItsHistoryDrawnByPlot) {
  const std::string run = oblique_run();
  const Outcome outcome = pennon({"plot", run + "/history.h5"});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("history_trailing_edge.svg"));
}

}  // namespace
}  // namespace pennon

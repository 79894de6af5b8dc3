/// pennon dns about a flag in prescribed motion, as a user runs it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/xdmf_check.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bad_input;
using test::done;
using test::not_converged;
using test::Outcome;
using testing::HasSubstr;

class DnsFluid : public test::Commands {
 protected:
  std::string case_file(const std::string& rest, const std::string& flag = "") {
    return test::write_text(folder_ / "case.toml",
                            "[flag]\nmu = 1\n" + flag + "[flow]\nRe = 200\n" + rest)
        .string();
  }
  std::string wave_in_three_dimensions() {
    return case_file(
        "[dns]\nn_x = 8\nn_rho = 16\nn_theta = 32\nwall_spacing = 0.05\ndt = 0.01\n"
        "t_end = 0.2\n[dns.motion]\nkind = \"wave\"\namplitude = 0.1\nwaves = 1\n"
        "[dns.probes]\ny = [1.5]\nz = [0.1]\n[dns.output]\nfield_interval = 0.1\n"
        "checkpoint_interval = 0.05\n",
        "gamma = 2\n");
  }
};

TEST_F(DnsFluid, GoesOnAfterATerminationToTheSameBits) {
  const std::string file = wave_in_three_dimensions();
  Outcome whole, continued;
  ASSERT_NO_FATAL_FAILURE(expect_same_after_termination(
      {"dns", file, "--set", "dns.t_end=0.6", "--set", "dns.output.checkpoint_interval=0", "--set",
       "dns.output.checkpoint_minutes=1e-4", "--json"},
      whole, continued));
  EXPECT_EQ(hdf5::Reader(results("parts") + "/fields_00006.h5").read("/omega_x").values,
            hdf5::Reader(results("whole") + "/fields_00006.h5").read("/omega_x").values);
}

TEST_F(DnsFluid, DoesNotDependOnTheNumberOfRanks) {
  const std::string file = wave_in_three_dimensions();
  std::vector<CsvTable> histories;
  for (const int ranks : {1, 2, 4}) {
    const std::string folder = results(std::to_string(ranks));
    const Outcome outcome = pennon_on(ranks, {"dns", file, "--json", "--output", folder});
    ASSERT_EQ(outcome.status, done) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out).at("dns").at("cells"), 8 * 16 * 32);
    histories.emplace_back(folder + "/history.csv");
  }
  constexpr double rounding = 1e-11;  // of sums of 1e4 numbers, and of the solvers they stop
  for (std::size_t k : {1UL, 2UL}) {
    ASSERT_EQ(histories[k].rows(), histories[0].rows());
    for (std::size_t row = 0; row < histories[0].rows(); ++row)
      for (const char* name : {"C_D", "C_L", "kinetic", "dissipation", "v_0", "p_0"}) {
        const std::size_t column = histories[0].column(name);
        EXPECT_NEAR(*histories[k].number(row, column), *histories[0].number(row, column), rounding)
            << name << " in row " << row;
      }
  }
  const auto omega = [&](const char* ranks) {
    return hdf5::Reader(results(ranks) + "/fields_00002.h5").read("/omega_s").values;
  };
  const std::vector<double> one = omega("1"), four = omega("4");
  ASSERT_EQ(one.size(), four.size());
  for (std::size_t cell = 0; cell < one.size(); ++cell) EXPECT_NEAR(one[cell], four[cell], 1e-8);
}

TEST_F(DnsFluid, KeepsFieldsThatParaViewOpens) {
  const std::string flow =
      "[dns]\nn_rho = 12\nn_theta = 24\nwall_spacing = 0.05\ndt = 0.01\nt_end = 0.04\n"
      "n_x = 4\n[dns.motion]\nkind = \"rigid\"\n[dns.output]\nfield_interval = 0.02\n";
  const std::vector<std::string> in_the_plane = {"v: Scalar at Cell", "w: Scalar at Cell",
                                                 "p: Scalar at Cell", "omega_x: Scalar at Cell"};
  const std::vector<std::string> in_space = {"v: Scalar at Cell",       "w: Scalar at Cell",
                                             "u: Scalar at Cell",       "p: Scalar at Cell",
                                             "omega_x: Scalar at Cell", "omega_y: Scalar at Cell",
                                             "omega_z: Scalar at Cell", "omega_s: Scalar at Cell"};
  for (const bool has_span : {false, true}) {
    const std::string file = case_file(flow, has_span ? "gamma = 1\n" : "");
    const Outcome outcome = pennon({"dns", file, "--quiet", "--force", "--output", results()});
    ASSERT_EQ(outcome.status, done) << outcome.err;
    const test::XdmfSummary found = test::check_xdmf(results() + "/fields.xdmf");
    EXPECT_THAT(found.faults, testing::IsEmpty());
    EXPECT_EQ(found.times.size(), 3U);
    EXPECT_EQ(found.attributes, has_span ? in_space : in_the_plane);
    EXPECT_EQ(pennon({"plot", results() + "/fields_00002.h5"}).status, done);
    EXPECT_TRUE(fs::exists(results() + "/fields_00002.png"));
  }
}

TEST_F(DnsFluid, SaysThatTwoDimensionsRunOnOneRank) {
  const std::string file =
      case_file("[dns]\nt_end = 0.01\ndt = 0.01\n[dns.motion]\nkind = \"rigid\"\n");
  const Outcome outcome = pennon_on(2, {"dns", file, "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("is one in two dimensions"));
}

TEST_F(DnsFluid, ReportsAllFaultsOfACase) {
  const std::string file = case_file(
      "[dns]\nn_theta = 121\ndt = 0.01\nfirst_dt = 0.1\n[dns.motion]\nkind = \"wave\"\n"
      "waves = 2\n[dns.probes]\ny = [1.0, 20.0]\nz = [0.0]\n");
  const Outcome outcome = pennon({"dns", file, "--check"});
  EXPECT_EQ(outcome.status, bad_input);
  for (const char* fault :
       {"n_theta = 121 is odd", "first_dt = 0.1 is larger", "motion.waves varies along the span",
        "probes.z has 1 numbers and dns.probes.y has 2"})
    EXPECT_THAT(outcome.err, HasSubstr(fault));
}

TEST_F(DnsFluid, RefusesTheCheckpointOfAnotherGrid) {
  const std::string file = wave_in_three_dimensions();
  ASSERT_EQ(
      pennon({"dns", file, "--quiet", "--set", "dns.t_end=0.02", "--output", results()}).status,
      done);
  const Outcome outcome = pennon({"dns", file, "--set", "dns.n_rho=18", "--restart",
                                  results() + "/checkpoint.h5", "--output", results("other")});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("dns.n_rho = 16 there, 18 here"));
}

TEST_F(DnsFluid, AFoldedGridStopsTheRunWithItsTime) {
  // The flag rises through the outer boundary.
  const std::string file = case_file(
      "[dns]\nn_rho = 16\nn_theta = 32\nwall_spacing = 0.05\nR = 1\ndt = 0.01\nt_end = 1\n"
      "[dns.motion]\nkind = \"heave\"\namplitude = 1.5\nfrequency = 0\nphase = "
      "1.5707963267948966\nramp = 1\n");
  const Outcome outcome = pennon({"dns", file, "--output", results()});
  EXPECT_EQ(outcome.status, not_converged);
  EXPECT_THAT(outcome.err, HasSubstr("at t = 0."));
  EXPECT_THAT(outcome.err, HasSubstr("the grid folds"));
  EXPECT_TRUE(fs::exists(results() + "/history.csv"));
}

TEST_F(DnsFluid, SaysWhereTheGridHasBecomeCoarseAtTheFlag) {
  const auto said = [&](double of_wave) {
    const std::string file = case_file(fmt::format(
        "[dns]\nn_rho = 16\nn_theta = 64\nwall_spacing = 0.05\nR = 4\ndt = 0.01\nt_end = 0.02\n"
        "[dns.motion]\nkind = \"wave\"\namplitude = {}\nk_y = 12.566\n",
        of_wave));
    const Outcome outcome = pennon({"dns", file, "--force", "--output", results()});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return outcome.out;
  };
  EXPECT_THAT(said(0.2), HasSubstr("times their thickness at rest"));
  EXPECT_THAT(said(0.01), Not(HasSubstr("times their thickness at rest")));
}

TEST_F(DnsFluid, FollowsANormalModeOfTheFlag) {
  const std::string file = case_file(
      "[modes.normal]\nfamily = \"in_vacuo\"\n[dns]\nn_rho = 16\nn_theta = 32\n"
      "wall_spacing = 0.05\ndt = 0.01\nt_end = 0.25\n[dns.motion]\nkind = \"mode\"\nm = 2\n"
      "amplitude = 0.05\nfrequency = 1\n");
  const Outcome outcome = pennon({"dns", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json last = json::parse(outcome.out).at("dns").at("last");
  EXPECT_NEAR(std::abs(last.at("z_trailing_edge").get<double>()), 0.05, 1e-6)
      << "a quarter of a period after the start, where the mode is largest";
}

// No row of the history falls due in a short run.
TEST_F(DnsFluid, EndsWhereItKeepsNoRow) {
  const std::string file = case_file(
      "[dns]\nn_rho = 16\nn_theta = 32\nwall_spacing = 0.05\ndt = 0.01\nt_end = 0.05\n"
      "[dns.motion]\nkind = \"rigid\"\n[dns.output]\nhistory_interval = 1\n"
      "field_interval = 1e-9\n");
  const Outcome outcome = pennon({"dns", file, "--output", results()});
  EXPECT_EQ(outcome.status, done) << outcome.err;
  EXPECT_EQ(outcome.err.find("picture"), std::string::npos) << outcome.err;
  EXPECT_TRUE(fs::exists(results() + "/fields_00005.h5")) << "one a step, and no more";
  EXPECT_FALSE(fs::exists(results() + "/fields_00006.h5"));
}

TEST_F(DnsFluid, KeepsToACourantNumber) {
  const std::string file = case_file(
      "[dns]\nn_rho = 24\nn_theta = 48\nwall_spacing = 0.03\ndt = 0.05\nfirst_dt = 0.0005\n"
      "cfl = 2\nt_end = 0.5\n[dns.motion]\nkind = \"rigid\"\n");
  const Outcome outcome = pennon({"dns", file, "--quiet", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const CsvTable history(results() + "/history.csv");
  const std::size_t last = history.rows() - 1;
  EXPECT_NEAR(*history.number(last, history.column("CFL")), 2, 0.1);
  EXPECT_NEAR(*history.number(last, history.column("t")), 0.5, 1e-12);
}

}  // namespace
}  // namespace pennon

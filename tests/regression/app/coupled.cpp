/// pennon dns of a flag that the flow moves, as a user runs it.
#include <fmt/format.h>
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
using test::other;
using test::Outcome;
using test::read_text;
using testing::AllOf;
using testing::HasSubstr;

class DnsCoupled : public test::Commands {
 protected:
  std::string case_file(const std::string& dns, const std::string& flag = "") {
    return test::write_text(folder_ / "case.toml",
                            "[flag]\nmu = 0.125\nK_B = 1e-4\ndamping = 0.02\n" + flag +
                                "[flow]\nRe = 500\n[dns]\nn_rho = 16\nn_theta = 32\nwall_spacing = "
                                "0.05\ndt = 0.005\n" +
                                dns)
        .string();
  }
  std::string in_three_dimensions() {
    return case_file(
        "n_x = 8\nt_end = 0.1\n[dns.initial]\nA = [0.01, 0.005]\nB = [0, 0.005]\n"
        "[dns.probes]\ny = [1.5]\nz = [0.1]\n[dns.output]\nshape_interval = 0.05\n"
        "checkpoint_interval = 0.05\n",
        "gamma = 2\n");
  }
  static double last(const CsvTable& history, const char* column) {
    return *history.number(history.rows() - 1, history.column(column));
  }
};

TEST_F(DnsCoupled, RunsAndKeepsWhatHappens) {
  const std::string file = case_file(
      "t_end = 0.3\n[dns.initial]\nmode_amplitude = 0.05\n[modes.normal]\nfamily = "
      "\"hanging_chain\"\n[dns.output]\nshape_interval = 0.1\nfield_interval = 0.3\n");
  const Outcome outcome = pennon({"dns", file, "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json dns = json::parse(outcome.out).at("dns");
  EXPECT_EQ(dns.at("status"), "done");
  EXPECT_GE(dns.at("coupling_iterations").at("mean"), 1);
  EXPECT_LE(dns.at("coupling_iterations").at("mean"), 4);
  const hdf5::Reader history(results() + "/history.h5");
  EXPECT_EQ(history.text("/", "kind"), "coupled_history");
  const hdf5::Shape rows = history.shape("/history"), edge = history.shape("/trailing_edge");
  EXPECT_EQ(edge, (hdf5::Shape{rows[0], 1, 3}));
  EXPECT_EQ(history.read("/trailing_edge").values.back(),
            dns.at("last").at("z_trailing_edge").get<double>());
  const CsvTable table(results() + "/history.csv");
  constexpr double tolerance = 1e-5;  // dns.coupling.tolerance, of a jump below 1
  for (const double residual : table.numbers("coupling_residual")) EXPECT_LE(residual, tolerance);
  EXPECT_NEAR(*table.number(0, table.column("z_trailing_edge")), 0.05, 1e-4);
  EXPECT_LT(std::abs(last(table, "flag_defect")), 1e-5);
  EXPECT_TRUE(test::check_xdmf(results() + "/shapes.xdmf").faults.empty());
  EXPECT_TRUE(test::check_xdmf(results() + "/fields.xdmf").faults.empty());
  EXPECT_TRUE(fs::exists(results() + "/history.png"));
}

TEST_F(DnsCoupled, GoesOnAfterATerminationToTheSameBits) {
  const std::string file = in_three_dimensions();
  Outcome whole, continued;
  ASSERT_NO_FATAL_FAILURE(
      expect_same_after_termination({"dns", file, "--set", "dns.t_end=0.4"}, whole, continued));
  EXPECT_EQ(hdf5::Reader(results("parts") + "/shapes.h5").read("/position/000008").values,
            hdf5::Reader(results("whole") + "/shapes.h5").read("/position/000008").values);
}

// Of a run of a second and more.
TEST_F(DnsCoupled, GoesOnAfterAnyInterruptToTheSameBits) {
  // mpiexec passes the signal on after a second, before which the run must not come to its end.
  const std::string file = in_three_dimensions();
  const auto arguments_on = [&](int ranks) -> std::vector<std::string> {
    return {"dns",   file,
            "--set", ranks == 1 ? "dns.t_end=0.6" : "dns.t_end=4",
            "--set", "dns.output.checkpoint_interval=0"};
  };
  const auto run_whole = [&](int ranks, const std::string& folder,
                             const std::vector<std::string>& more = {}) {
    std::vector<std::string> words = arguments_on(ranks);
    words.insert(words.end(), {"--output", results(folder)});
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = ranks == 1 ? pennon(words) : pennon_on(ranks, words);
    ASSERT_EQ(outcome.status, done) << outcome.err;
  };
  const auto expect_the_same = [&](int signal, const char* name, int ranks,
                                   const std::string& whole) {
    const std::string folder = name + std::to_string(ranks);
    const Outcome stopped = pennon_stopped(signal, ranks, arguments_on(ranks), folder);
    EXPECT_EQ(stopped.status, other) << folder << ": " << stopped.err;
    // mpiexec passes nothing on any more once it is stopped itself.
    if (ranks == 1) {
      EXPECT_THAT(stopped.err,
                  AllOf(HasSubstr(fmt::format("stopped by {}", name)), HasSubstr("--restart")));
    }
    run_whole(ranks, folder, {"--restart", results(folder) + "/checkpoint.h5"});
    EXPECT_EQ(read_text(results(folder) + "/history.csv"),
              read_text(results(whole) + "/history.csv"))
        << folder;
    const hdf5::Reader shapes(results(folder) + "/shapes.h5");
    const hdf5::Reader expected(results(whole) + "/shapes.h5");
    for (const char* shape : {"/position/000000", "/position/000012"})
      EXPECT_EQ(shapes.read(shape).values, expected.read(shape).values) << folder << shape;
  };
  run_whole(1, "whole1");
  expect_the_same(SIGTERM, "SIGTERM", 1, "whole1");
  expect_the_same(SIGINT, "Ctrl-C", 1, "whole1");
  run_whole(2, "whole2");
  expect_the_same(SIGTERM, "SIGTERM", 2, "whole2");
}

TEST_F(DnsCoupled, DoesNotDependOnTheNumberOfRanks) {
  const std::string file = in_three_dimensions();
  std::vector<CsvTable> histories;
  for (const int ranks : {1, 2, 4}) {
    const std::string folder = results(std::to_string(ranks));
    const Outcome outcome = pennon_on(ranks, {"dns", file, "--output", folder});
    ASSERT_EQ(outcome.status, done) << outcome.err;
    histories.emplace_back(folder + "/history.csv");
  }
  // The solvers stop at a tolerance; what they leave differs by rounding, and a flag answers it.
  constexpr double rounding = 1e-8;
  for (std::size_t k : {1UL, 2UL})
    for (const char* name : {"z_trailing_edge", "C_D", "C_L", "flag_kinetic", "v_0"})
      EXPECT_NEAR(last(histories[k], name), last(histories[0], name), rounding) << name;
}

TEST_F(DnsCoupled, GoesOnWithAnotherNumberOfRanks) {
  const std::string file = in_three_dimensions();
  ASSERT_EQ(pennon({"dns", file, "--output", results()}).status, done);
  const auto go_on = [&](int ranks) {
    const std::string folder = results(std::to_string(ranks));
    const Outcome outcome = pennon_on(ranks, {"dns", file, "--set", "dns.t_end=0.2", "--restart",
                                              results() + "/checkpoint.h5", "--output", folder});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return last(CsvTable(folder + "/history.csv"), "z_trailing_edge");
  };
  EXPECT_NEAR(go_on(2), go_on(1), 1e-9);
}

TEST_F(DnsCoupled, HoldsTheFlagUntilItsReleaseAndKicksIt) {
  const std::string file =
      case_file("t_end = 0.3\n[dns.initial]\nrelease = 0.2\nkick = 0.01\nkick_duration = 0.05\n");
  ASSERT_EQ(pennon({"dns", file, "--output", results()}).status, done);
  const CsvTable history(results() + "/history.csv");
  double before = 0;
  for (std::size_t row = 0; row < history.rows(); ++row)
    if (*history.number(row, history.column("t")) < 0.199)
      before = std::max(before, std::abs(*history.number(row, history.column("z_trailing_edge"))));
  EXPECT_EQ(before, 0);
  EXPECT_GT(last(history, "z_trailing_edge"), 1e-4);
}

TEST_F(DnsCoupled, SaysWhereAStartIsTooSteep) {
  const std::string file = case_file("t_end = 0.1\n[dns.initial]\nA = [1.5]\n");
  const Outcome outcome = pennon({"dns", file, "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("steeper than the flag is long"));
}

TEST_F(DnsCoupled, SaysWhenFlagAndFluidDoNotAgree) {
  const std::string file = case_file(
      "t_end = 0.1\n[dns.initial]\nA = [0.05]\n[dns.coupling]\nmost_passes = 1\ntolerance = "
      "1e-9\n");
  const Outcome outcome = pennon({"dns", file, "--output", results()});
  EXPECT_EQ(outcome.status, not_converged);
  EXPECT_THAT(outcome.err, HasSubstr("did not agree in 1 passes"));
  EXPECT_THAT(outcome.err, HasSubstr("no checkpoint was written before"));
}

TEST_F(DnsCoupled, ReportsFaultsOfACase) {
  const std::string file = case_file(
      "t_end = 0.1\n[dns.initial]\nA = [0.05]\nmode_amplitude = 0.1\n[dns.flag]\ntrailing_edge = "
      "\"pinned\"\n[dns.loads]\npressure = 0.1\n");
  const Outcome outcome = pennon({"dns", file, "--check"});
  EXPECT_EQ(outcome.status, bad_input);
  for (const char* fault : {"initial.mode_amplitude", "dns.flag", "dns.loads"})
    EXPECT_THAT(outcome.err, HasSubstr(fault));
}

}  // namespace
}  // namespace pennon

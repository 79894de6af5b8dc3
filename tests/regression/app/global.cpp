/// pennon modes of a case with [modes.global], as a user runs it.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <thread>

#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/xdmf_check.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using test::bad_input;
using test::done;
using test::Outcome;
using testing::HasSubstr;

// The modes of flag and wake; those of the box are behind them.
json without_box(const json& modes) {
  json others = json::array();
  for (const json& mode : modes)
    if (mode.at("kind") != "box") others.push_back(mode);
  for (std::size_t k = 0; k < others.size(); ++k) EXPECT_EQ(others[k], modes[k]);
  return others;
}

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
  const std::string file = case_file("n_modes = 2\ntarget = [0.4, 2.6]\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json global = json::parse(outcome.out).at("global");
  EXPECT_EQ(global.at("requested"), 2);
  EXPECT_EQ(global.at("converged"), 2);
  const json& base = global.at("base_flow");
  EXPECT_NEAR(base.at("tension_leading_edge"), base.at("drag_coefficient").get<double>() / 2,
              1e-12);
  EXPECT_LT(base.at("residual"), 1e-8);
  EXPECT_EQ(without_box(global.at("modes")).size(), 2u);
  const std::size_t modes = global.at("modes").size();
  EXPECT_EQ(modes, 2 + std::min<std::size_t>(2, global.at("box")));
  for (const json& mode : global.at("modes")) {
    double sum = 0;
    for (const json& share : mode.at("shares")) sum += share.get<double>();
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_LT(mode.at("residual"), 1e-6);
    EXPECT_NEAR(mode.at("frequency"), mode.at("omega").get<double>() / (2 * M_PI), 1e-12);
  }
  EXPECT_GE(global.at("modes")[0].at("growth"), global.at("modes")[1].at("growth"));
  const CsvTable table(results() + "/global_modes.csv"), shapes(results() + "/global_shapes.csv");
  EXPECT_EQ(table.rows(), modes);
  EXPECT_EQ(shapes.rows(), modes * 17u);
  EXPECT_EQ(json::parse(test::read_text(results() + "/summary.json")).at("global"), global);
}

TEST_F(ModesGlobal, FindsTheLeadingModesWithoutATarget) {
  const std::string file = case_file("n_modes = 4\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json modes = without_box(json::parse(outcome.out).at("global").at("modes"));
  ASSERT_EQ(modes.size(), 4u);
  EXPECT_NEAR(modes[0].at("growth"), 0.44, 0.03);
  EXPECT_NEAR(modes[0].at("omega"), 2.66, 0.1);
  for (std::size_t k = 1; k < modes.size(); ++k)
    EXPECT_LE(modes[k].at("growth"), modes[k - 1].at("growth"));
}

TEST_F(ModesGlobal, FindsAllModesNextToATargetThatIsOne) {
  const auto modes = [&](const std::string& target) {
    const std::string file = case_file("n_modes = 2\ntarget = " + target + "\n");
    const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return without_box(json::parse(outcome.out).at("global").at("modes"));
  };
  const json beside = modes("[0.4, 2.6]");
  const json on_one = modes(fmt::format("[{}, {}]", beside.at(0).at("growth").get<double>(),
                                        beside.at(0).at("omega").get<double>()));
  ASSERT_EQ(beside.size(), 2u);
  ASSERT_EQ(on_one.size(), 2u);
  for (const json& mode : on_one) EXPECT_LT(mode.at("residual"), 1e-8);
  EXPECT_NEAR(on_one.at(0).at("growth"), beside.at(0).at("growth"), 1e-9);
}

TEST_F(ModesGlobal, TakesTheWaveOfTheSpan) {
  const std::string file = case_file("n_modes = 1\ntarget = [-0.1, 2.8]\n", "gamma = 2\n");
  const Outcome wave = pennon({"modes", file, "--json", "--force", "--output", results()});
  ASSERT_EQ(wave.status, done) << wave.err;
  const Outcome same = pennon({"modes",
                               case_file("n_modes = 1\ntarget = [-0.1, 2.8]\nk_x = "
                                         "3.141592653589793\n"),
                               "--json", "--output", results("other")});
  ASSERT_EQ(same.status, done) << same.err;
  EXPECT_EQ(json::parse(wave.out).at("global"), json::parse(same.out).at("global"));
}

// The names at the cells of a mode, each in its real and its imaginary part.
std::vector<std::string> attributes_of(const std::vector<std::string>& base,
                                       const std::vector<std::string>& mode) {
  std::vector<std::string> attributes;
  attributes.reserve(base.size() + 2 * mode.size());
  for (const std::string& name : base) attributes.push_back("base_" + name + ": Scalar at Cell");
  for (const std::string& name : mode)
    for (const char* part : {"_real", "_imag"})
      attributes.push_back(
          name + part +
          (name.starts_with("displacement") ? ": Scalar at Node" : ": Scalar at Cell"));
  return attributes;
}

TEST_F(ModesGlobal, KeepsFieldsThatParaViewOpensOfFlowModesAndWavemaker) {
  const std::string file =
      case_file("n_modes = 2\ntarget = [-0.1, 2.8]\nadjoint = true\n", "gamma = 2\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  EXPECT_LT(json::parse(outcome.out).at("global").at("biorthogonality_defect"), 1e-8);
  const test::XdmfSummary found = test::check_xdmf(results() + "/global_modes.xdmf");
  EXPECT_THAT(found.faults, testing::IsEmpty());
  EXPECT_EQ(found.times, (std::vector<double>{1, 2}));
  std::vector<std::string> expected = attributes_of(
      {"v", "w", "u", "p", "omega_x"},
      {"v", "w", "u", "p", "omega_x", "fixed_v", "fixed_w", "fixed_u", "fixed_p", "fixed_omega_x",
       "displacement_y", "displacement_z", "adjoint_v", "adjoint_w", "adjoint_u", "adjoint_p"});
  expected.emplace_back("wavemaker: Scalar at Cell");
  EXPECT_EQ(found.attributes, expected);

  const hdf5::Reader fields(results() + "/global_modes.h5");
  EXPECT_EQ(fields.number("/", "mu", 0), 0.3);
  EXPECT_EQ(fields.number("/", "k_x", 0), M_PI);
  EXPECT_EQ(fields.shape("/base/is_inflow"), (hdf5::Shape{32}));
  EXPECT_EQ(fields.shape("/flag"), (hdf5::Shape{17, 2}));
  const auto defect = [&](const std::string& name, double sign) {
    const hdf5::Array array = fields.read(name);
    const std::size_t n_theta = array.shape[1];
    double largest = 0, of = 0;
    for (std::size_t k = 0; k < array.values.size(); ++k) {
      const std::size_t row = k / n_theta, column = k % n_theta;
      const double mirrored = array.values[row * n_theta + n_theta - 1 - column];
      largest = std::max(largest, std::abs(array.values[k] - sign * mirrored));
      of = std::max(of, std::abs(array.values[k]));
    }
    return largest / of;
  };
  constexpr double rounding = 1e-6;
  for (const char* odd : {"/mode_1/v_real", "/mode_1/u_imag", "/mode_1/p_real", "/base/w",
                          "/base/omega_x", "/mode_2/fixed_v_imag", "/mode_2/adjoint_p_real"})
    EXPECT_LT(defect(odd, -1), rounding) << odd;
  for (const char* even : {"/mode_1/w_real", "/mode_1/omega_x_imag", "/base/v", "/base/p",
                           "/mode_2/fixed_omega_x_real", "/mode_2/wavemaker"})
    EXPECT_LT(defect(even, 1), rounding) << even;

  const CsvTable shapes(results() + "/global_shapes.csv"),
      feedback(results() + "/global_flag_feedback.csv");
  constexpr std::size_t nodes = 17;
  EXPECT_EQ(feedback.rows(), 2 * nodes);
  const hdf5::Array phases = fields.read("/mode_1/shapes");
  ASSERT_EQ(phases.shape, (hdf5::Shape{4, nodes}));
  const std::vector<double> wavemaker = fields.read("/mode_1/flag_wavemaker").values,
                            at_135 = shapes.numbers("at_135"), at_45 = shapes.numbers("at_45"),
                            at_0 = shapes.numbers("zeta_real"),
                            of_imag = shapes.numbers("zeta_imag");
  for (std::size_t j = 0; j < nodes; ++j) {
    EXPECT_NEAR(phases.values[3 * nodes + j], at_135[j], 1e-12);
    EXPECT_NEAR(at_45[j], (at_0[j] - of_imag[j]) / std::sqrt(2), 1e-12);
    EXPECT_NEAR(feedback.numbers("wavemaker")[j], wavemaker[j], 1e-12 * (1 + wavemaker[j]));
  }
  for (const char* picture :
       {"global_modes.png", "global_modes_mode_1_shape.png", "global_modes_mode_2_vorticity.png",
        "global_modes_mode_1_wavemaker.png", "global_modes_mode_2_flag_wavemaker.png"})
    EXPECT_TRUE(std::filesystem::exists(results() + "/" + picture)) << picture;
}

// Half a period apart the mode has the other sign; the first frame is its real part.
TEST_F(ModesGlobal, AnimatesTheModesOverTheirPeriod) {
  for (const char* span : {"", "gamma = 2\n"}) {
    const std::string file = case_file("n_modes = 1\ntarget = [0.1, 2.8]\nframes = 4\n", span);
    const Outcome outcome =
        pennon({"modes", file, "--json", "--quiet", "--force", "--output", results()});
    ASSERT_EQ(outcome.status, done) << outcome.err;
    const double omega = json::parse(outcome.out).at("global").at("modes")[0].at("omega");
    const test::XdmfSummary fluid = test::check_xdmf(results() + "/global_mode_1.xdmf"),
                            flag = test::check_xdmf(results() + "/global_mode_1_flag.xdmf");
    EXPECT_THAT(fluid.faults, testing::IsEmpty());
    EXPECT_THAT(flag.faults, testing::IsEmpty());
    ASSERT_EQ(fluid.times.size(), 4u);
    EXPECT_NEAR(fluid.times[1], M_PI / 2 / omega, 1e-12);
    EXPECT_EQ(flag.times, fluid.times);
    EXPECT_THAT(fluid.attributes, testing::Contains("velocity: Vector at Cell"));
    EXPECT_FALSE(std::filesystem::exists(results() + "/global_mode_2.xdmf"));

    const hdf5::Reader frames(results() + "/global_mode_1.h5"),
        modes(results() + "/global_modes.h5");
    const hdf5::Array velocity = frames.read("/frame_1/velocity"),
                      opposite = frames.read("/frame_3/velocity"),
                      of_mode = frames.read("/frame_2/mode_velocity"),
                      nodes = frames.read("/frame_1/flag");
    const std::vector<double> base = modes.read("/base/w").values,
                              v_real = modes.read("/mode_1/v_real").values,
                              v_imag = modes.read("/mode_1/v_imag").values,
                              zeta = modes.read("/mode_1/zeta_real").values;
    const double k_x = frames.number("/", "k_x", 0),
                 planes = static_cast<double>(velocity.shape[0]);
    const std::complex<double> turn = std::polar(1.0, k_x == 0 ? 0 : M_PI / planes + M_PI / 2),
                               quarter(0, 1);
    for (std::size_t k = 0; k < base.size(); ++k) {
      EXPECT_NEAR(velocity.values[3 * k + 2] + opposite.values[3 * k + 2], 2 * base[k], 1e-12);
      const std::complex<double> v(v_real[k], v_imag[k]);
      const double expected = (v * (k_x == 0 ? quarter : turn)).real();
      EXPECT_NEAR(of_mode.values[3 * k + 1], expected, 1e-12 * (1 + std::abs(v)));
    }
    for (std::size_t j = 0; j < zeta.size(); ++j)
      EXPECT_NEAR(nodes.values[3 * j + 2], 0.1 * zeta[j], 1e-14);
  }
}

TEST_F(ModesGlobal, FindsTheNeutralCurveAndChecksItByTheFullOperator) {
  const std::string file = case_file(
      "n_modes = 0\n[modes.global.neutral]\nRe = [280, 300]\nmu = [0.02, 2]\nomega = [1, 10]\n"
      "[lsa]\nadded_mass = \"wu\"\n");
  const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
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
  const Outcome outcome = pennon({"modes", file, "--json", "--force", "--output", results()});
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

TEST_F(ModesGlobal, OnSeveralRanksFindsTheSame) {
  allow_ranks();
  const std::string file =
      case_file("n_modes = 2\ntarget = [-0.1, 2.8, -0.5, 4]\nadjoint = true\n", "gamma = 2\n");
  const auto modes = [&](int ranks) {
    const Outcome outcome =
        pennon({"modes", file, "--set", fmt::format("modes.global.ranks={}", ranks), "--json",
                "--force", "--output", results()});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return json::parse(outcome.out).at("global").at("modes");
  };
  const json one = modes(1), two = modes(2);
  ASSERT_GE(one.size(), 2u);
  ASSERT_EQ(two.size(), one.size());
  for (std::size_t k = 0; k < one.size(); ++k) {
    EXPECT_EQ(two[k].at("kind"), one[k].at("kind"));
    EXPECT_LT(two[k].at("residual"), 1e-9);
    EXPECT_LT(two[k].at("adjoint_residual"), 1e-9);
    EXPECT_NEAR(two[k].at("growth"), one[k].at("growth"), 1e-8);
    EXPECT_NEAR(two[k].at("omega"), one[k].at("omega"), 1e-8);
  }
}

TEST_F(ModesGlobal, OnRanksOfItsOwnSaysWhichKeySharesTheWork) {
  const Outcome outcome =
      pennon_on(2, {"modes", case_file("target = [0.4, 2.6]\n"), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("modes.global.ranks = 2 shares the work"));
}

// MUMPS may have one megabyte.
TEST_F(ModesGlobal, SaysWhatMemoryItsFactorsNeed) {
  allow_ranks();
  setenv("PETSC_OPTIONS", "-global_mat_mumps_icntl_23 1", 1);
  for (const char* ranks : {"1", "2"}) {
    const Outcome outcome =
        pennon({"modes", case_file("target = [0.4, 2.6]\n"), "--set",
                std::string("modes.global.ranks=") + ranks, "--force", "--output", results()});
    EXPECT_EQ(outcome.status, test::not_converged);
    EXPECT_THAT(outcome.err, HasSubstr("the factors of 768 unknowns need about"));
    EXPECT_THAT(outcome.err, HasSubstr("a smaller modes.global.n_rho or n_theta needs less"));
    EXPECT_THAT(outcome.err, Not(HasSubstr("mpiexec")));
    EXPECT_FALSE(std::filesystem::exists(results() + "/global_modes.json"));
  }
  unsetenv("PETSC_OPTIONS");
}

TEST_F(ModesGlobal, PassesOnWhatItsProgramSays) {
  const Outcome outcome =
      pennon({"modes", case_file("wall_spacing = 1e-6\n"), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(
      outcome.err,
      HasSubstr(
          "case.toml:12: modes.global makes no grid: dns.wall_spacing = 1e-06 does not reach"));
}

// On a grid on which the whole takes ten seconds and more.
TEST_F(ModesGlobal, EndsSoonAfterATermination) {
  const std::string file = case_file("n_modes = 6\nn_rho = 100\nn_theta = 200\n");
  const pid_t child = start_in_background({"modes", file, "--output", results()});
  while (!std::filesystem::exists(results() + "/global_problem.toml") &&
         waitpid(child, nullptr, WNOHANG) == 0)
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  kill(child, SIGTERM);
  const auto begin = std::chrono::steady_clock::now();
  const Outcome outcome = finish(child);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(4));
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("stopped by SIGTERM"));
  EXPECT_FALSE(std::filesystem::exists(results() + "/global_modes.json"));
}

// The analysis of a run that starts as the first of the modes.
class StartAsAGlobalMode : public ModesGlobal {
 protected:
  // The modes of the case, and the case of the run.
  std::string run_file(const std::string& target, const std::string& flag,
                       const std::string& more = "") {
    const std::string file =
        case_file("n_modes = 1\ntarget = " + target + "\nn_x = 4\n" + more, flag);
    const Outcome outcome = pennon({"modes", file, "--quiet", "--output", results("modes")});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return test::write_text(folder_ / "run.toml",
                            test::read_text(file) + "[dns.initial]\nglobal_modes = \"" +
                                results("modes") + "/global_modes.h5\"\nmode_amplitude = 1e-4\n")
        .string();
  }
  void expect_growth(const std::string& target, const std::string& flag,
                     const std::string& more = "") {
    const std::string file = run_file(target, flag, more);
    const CsvTable modes(results("modes") + "/global_modes.csv");
    const double sigma_of_mode = modes.numbers("growth").front(),
                 omega_of_mode = modes.numbers("omega").front();
    const Outcome run = pennon({"dns", file, "--quiet", "--set", "dns.t_end=5", "--set",
                                "dns.n_x=4", "--output", results("run")});
    ASSERT_EQ(run.status, done) << run.err;
    const Outcome said = pennon({"analyze", results("run"), "--json"});
    const json growth = json::parse(said.out).at("analyze").at("growth");
    const double size = std::hypot(sigma_of_mode, omega_of_mode);
    EXPECT_NEAR(growth.at("sigma"), sigma_of_mode, 3e-3 * size);
    EXPECT_NEAR(growth.at("omega"), omega_of_mode, 3e-3 * size);
  }
  void expect_fault(const std::string& file, const std::string& setting,
                    const std::string& sentence) {
    const Outcome outcome =
        pennon({"dns", file, "--quiet", "--set", setting, "--output", results("run")});
    EXPECT_EQ(outcome.status, bad_input) << setting;
    EXPECT_THAT(outcome.err, HasSubstr(sentence)) << setting;
  }
};

TEST_F(StartAsAGlobalMode, GrowsAsItFromTheFirstStep) {
  expect_growth("[0.44, 2.66]", "damping = 0.02\n");
}

TEST_F(StartAsAGlobalMode, DecaysAsAWaveAlongTheSpan) {
  expect_growth("[-0.1, 2.8]", "damping = 0.02\ngamma = 2\n");
}

TEST_F(StartAsAGlobalMode, GrowsAsItWithOtherDifferences) {
  expect_growth("[0.44, 2.66]", "damping = 0.02\n", "[dns.fluid]\nconvection = \"third_order\"\n");
}

TEST_F(StartAsAGlobalMode, RefusesAnotherWave) {
  const std::string file = run_file("[-0.1, 2.8]", "gamma = 2\n");
  expect_fault(file, "dns.n_x=8",
               "was made with 4 spanwise nodes in a wave; here dns.n_x = 8 gives it 8");
  expect_fault(file, "flag.gamma=3.0", "has 1.5 waves (k_x = 3.14159) in a span of flag.gamma = 3");
}

TEST_F(StartAsAGlobalMode, RefusesAFileThatDoesNotServe) {
  const std::string file = run_file("[0.44, 2.66]", "");
  expect_fault(file, "dns.n_rho=20", "was made on 16 x 32 cells; here they are 20 x 32");
  expect_fault(file, "dns.R=5.0", "was made on another grid");
  expect_fault(file, "flag.mu=0.2", "was made with flag.mu = 0.3; here it is 0.2");
  expect_fault(file, "flow.Re=200.0", "was made with flow.Re = 300; here it is 200");
  expect_fault(file, "dns.initial.global_mode=3", "holds 1 modes; dns.initial.global_mode = 3");
  expect_fault(file, "dns.initial.ramp=1.0", "contradict");
  expect_fault(file, "dns.initial.mode_amplitude=0.0", "dns.initial.mode_amplitude is missing");
  expect_fault(file, "dns.initial.global_modes=case.toml", "case.toml");
  expect_fault(file, "dns.initial.global_modes=nowhere.h5", "where there is no file");
}

}  // namespace
}  // namespace pennon

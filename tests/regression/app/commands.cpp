/// The command as a user runs it: exit codes, messages, files, the paper's cases.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include "common/io/csv.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/text_file.hpp"
#include "tests/support/xdmf_check.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

using test::bad_input;
using test::done;
using test::not_converged;
using test::other;
using test::Outcome;
using test::source;
using test::table_1_cases;

using Lsa = test::Commands;
using Modes = test::Commands;
using Dns = test::Commands;
using Pennon = test::Commands;

std::string case_of(const std::string& name) {
  return (table_1_cases / (name + ".toml")).string();
}

TEST_F(Lsa, GivesTheVerdictOfEveryRowOfTable1) {
  const CsvTable table(source / "data/reference/table1.csv");
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const std::string name = table.text(row, table.column("case"));
    const Outcome outcome = pennon({"lsa", case_of(name), "--json", "--output", results(name)});
    ASSERT_EQ(outcome.status, done) << name << outcome.err;
    const json lsa = json::parse(outcome.out).at("lsa");
    EXPECT_EQ(lsa.at("unstable").get<bool>(), table.text(row, table.column("lsa")) == "U") << name;
    for (const char* key : {"k_x", "k_y", "c_m", "P", "omega", "growth", "frequency", "mu_cr"})
      EXPECT_TRUE(lsa.contains(key)) << key;
  }
}

TEST_F(Lsa, FindsTheWavenumbersThatReproduceTable1) {
  const Outcome outcome = pennon({"lsa", (source / "data/cases/verdicts_of_table1.toml").string(),
                                  "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json verdicts = json::parse(outcome.out).at("lsa").at("verdicts");
  EXPECT_EQ(verdicts.at("agreeing"), 18);
  EXPECT_EQ(verdicts.at("reproduced_for_k_y").size(), 1U);
  EXPECT_TRUE(fs::exists(results() + "/verdicts.png"));
}

TEST_F(Lsa, RunsTheResolvedCaseToTheSameNumbers) {
  const std::vector<std::string> common = {"--json", "--quiet", "--set", "lsa.added_mass=lamb"};
  std::vector<std::string> first = {"lsa", case_of("C2U025"), "--output", results("first")};
  first.insert(first.end(), common.begin(), common.end());
  const Outcome original = pennon(first);
  ASSERT_EQ(original.status, done) << original.err;
  const Outcome again = pennon(
      {"lsa", results("first") + "/case.resolved.toml", "--json", "--output", results("again")});
  ASSERT_EQ(again.status, done) << again.err;
  EXPECT_EQ(json::parse(again.out), json::parse(original.out));
}

TEST_F(Lsa, LeavesARecordOfWhatMadeTheResult) {
  ASSERT_EQ(pennon({"lsa", case_of("B1"), "--quiet", "--output", results()}).status, done);
  const json record = json::parse(test::read_text(results() + "/record.json"));
  for (const char* key : {"pennon", "command", "libraries", "ranks", "wall_s", "peak_memory_kB"})
    EXPECT_TRUE(record.contains(key)) << key;
}

TEST_F(Lsa, PrintsTheResolvedCaseAndComputesNothingWhenOnlyChecking) {
  const Outcome outcome = pennon({"lsa", case_of("C2D"), "--check", "--output", results()});
  EXPECT_EQ(outcome.status, done);
  EXPECT_THAT(outcome.out, HasSubstr("added_mass = \"wu\""));
  EXPECT_THAT(outcome.out, HasSubstr("K_S = 500.0"));
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Lsa, ReportsAllFaultsOfACaseWithTheirLines) {
  const fs::path file =
      test::write_text(folder_ / "bad.toml",
                       "[flag]\nmu = -1\nnus = 0.3\ngamma = 2.0\n[flow]\nRe = inf\n"
                       "[lsa]\nk_x = 1.0\n[lsa.map]\n"
                       "k_y = { from = 1, to = 2, points = 9000000 }\n"
                       "mu = { from = 1, to = 2, points = 9000000 }\n");
  const Outcome outcome = pennon({"lsa", file.string(), "--output", results()});
  EXPECT_EQ(outcome.status, bad_input);
  for (const char* line : {":2: flag.mu must be > 0", ":3: flag.nus is not a setting; did you mean",
                           ":6: flow.Re must be", ":8: lsa.k_x = 1 contradicts flag.gamma",
                           ":9: lsa.map has 8.1e+13 points"})
    EXPECT_THAT(outcome.err, HasSubstr(line));
  EXPECT_FALSE(fs::exists(results()));
}

TEST_F(Lsa, FindsAnUnwritableFolderBeforeTheWork) {
  const Outcome outcome = pennon({"lsa", case_of("C2D"), "--output", "/proc/nowhere"});
  EXPECT_EQ(outcome.status, other);
  EXPECT_THAT(outcome.err, HasSubstr("/proc/nowhere"));
}

TEST_F(Lsa, SaysWhichTableIsMissing) {
  const Outcome outcome = pennon({"lsa", case_of("C2D"), "--set", "lsa.marks.table=none.csv"});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("none.csv"));
}

// A map that takes some seconds.
std::vector<std::string> long_map(const std::string& output) {
  return {"lsa",      (source / "data/cases/lsa/map_of_1e8_points.toml").string(),
          "--output", output,
          "--set",    "lsa.map.fields=[\"growth\"]"};
}

TEST_F(Lsa, KilledLeavesNoHalfWrittenFileUnderAFinalName) {
  const pid_t child = start_in_background(long_map(results()));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  kill(child, SIGKILL);
  EXPECT_EQ(finish(child).status, -SIGKILL);
  EXPECT_FALSE(fs::exists(results() + "/map.h5"));
  EXPECT_FALSE(fs::exists(results() + "/summary.json"));
}

TEST_F(Lsa, InterruptedSaysHowToGoOnAndCleansUp) {
  const pid_t child = start_in_background(long_map(results()));
  std::this_thread::sleep_for(std::chrono::milliseconds(400));
  kill(child, SIGTERM);
  const Outcome outcome = finish(child);
  EXPECT_EQ(outcome.status, other);
  EXPECT_THAT(outcome.err, HasSubstr("run the same command again"));
  for (const auto& entry : fs::directory_iterator(results()))
    EXPECT_THAT(entry.path().filename().string(), Not(HasSubstr("map")));
}

TEST_F(Modes, ListsTheNormalModesOfTheContract) {
  const Outcome outcome = pennon({"modes", case_of("C2"), "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json modes = json::parse(outcome.out).at("normal");
  ASSERT_EQ(modes.size(), 9U);
  for (const char* key : {"family", "n", "m", "alpha", "omega"})
    EXPECT_TRUE(modes[0].contains(key));
  for (const char* file : {"modes.csv", "modes.h5", "modes.png", "modes.svg"})
    EXPECT_TRUE(fs::exists(results() + "/" + file)) << file;
}

TEST_F(Dns, BendsTheElasticaOfItsCase) {
  const Outcome outcome = pennon({"dns", (source / "data/cases/flag/elastica.toml").string(),
                                  "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json last = json::parse(outcome.out).at("dns").at("last");
  EXPECT_NEAR(last.at("y").get<double>(), 0.78771, 1e-4);
  EXPECT_NEAR(last.at("z").get<double>(), 0.55833, 1e-4);
}

TEST_F(Dns, TakesTheTractionOfATableAsItTakesAUniformLoad) {
  std::string table = "y,f_y,f_z\n";
  for (int j = 0; j <= 20; ++j) table += std::to_string(j / 20.0) + ",0,0.5\n";
  test::write_text(folder_ / "traction.csv", table);
  const fs::path file = test::write_text(folder_ / "case.toml",
                                         "[flag]\nmu = 1\nK_B = 1\nleading_edge = \"clamped\"\n"
                                         "[dns.flag]\nn_y = 21\nequilibrium = true\n");
  const auto deflection = [&](const std::string& load) {
    const Outcome outcome =
        pennon({"dns", file.string(), "--json", "--force", "--output", results(), "--set", load});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return json::parse(outcome.out).at("dns").at("last").at("z").get<double>();
  };
  const double of_table = deflection("dns.loads.traction=" + (folder_ / "traction.csv").string());
  EXPECT_NEAR(of_table, 0.5 / 8, 0.002) << "a cantilever under a uniform load: q L^4/(8 EI)";
  EXPECT_NEAR(deflection("dns.loads.load=[0,0,0.5]"), of_table, 1e-12);
}

TEST_F(Dns, GoesOnAfterATerminationToTheSameBits) {
  const std::string file = (source / "data/cases/flag/swinging_membrane.toml").string();
  Outcome whole, continued;
  ASSERT_NO_FATAL_FAILURE(expect_same_after_termination(
      {"dns", file, "--set", "dns.n_x=8", "--set", "dns.flag.n_y=12", "--set", "dns.t_end=2.5",
       "--set", "dns.output.checkpoint_interval=0.5", "--json"},
      whole, continued));
  EXPECT_EQ(json::parse(continued.out).at("dns").at("last"),
            json::parse(whole.out).at("dns").at("last"));
}

// The work of loads and what the damping took are sums over the whole run.
TEST_F(Dns, GoesOnWithTheWorkOfItsLoads) {
  const std::string file = (source / "data/cases/flag/swinging_membrane.toml").string();
  Outcome whole, continued;
  ASSERT_NO_FATAL_FAILURE(expect_same_after_termination(
      {"dns", file, "--set", "dns.n_x=6", "--set", "dns.flag.n_y=8", "--set", "dns.t_end=2.5",
       "--set", "dns.loads.load=[0,0,0.5]", "--set", "flag.damping=0.01", "--set",
       "dns.output.checkpoint_interval=0.5", "--json"},
      whole, continued));
  const CsvTable history(results("parts") + "/history.csv");
  const auto last = [&](const char* name) {
    return *history.number(history.rows() - 1, history.column(name));
  };
  EXPECT_GT(std::abs(last("work")), 0.01) << "the loads do work";
  EXPECT_GT(last("dissipated"), 0);
}

TEST_F(Dns, RefusesTheCheckpointOfAnotherFlag) {
  const std::string file = (source / "data/cases/flag/hanging_chain.toml").string();
  ASSERT_EQ(
      pennon({"dns", file, "--quiet", "--set", "dns.t_end=0.01", "--output", results()}).status,
      done);
  const Outcome outcome = pennon({"dns", file, "--set", "dns.flag.n_y=51", "--restart",
                                  results() + "/checkpoint.h5", "--output", results("other")});
  EXPECT_EQ(outcome.status, bad_input);
  EXPECT_THAT(outcome.err, HasSubstr("dns.flag.n_y = 101 there, 51 here"));
}

// The discrete frequency is that of the grid's second differences, 4 (N - 1)^2 sin^2(pi/(2 (N -
// 1))) each way, exactly.
TEST_F(Dns, FindsTheOrderOfItsStepsByFigure22) {
  const Outcome outcome =
      pennon({"dns", (source / "data/cases/flag/figure22.toml").string(), "--set", "dns.n_x=9",
              "--set", "dns.flag.n_y=9", "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json found = json::parse(outcome.out).at("convergence");
  EXPECT_EQ(found.at("dt").size(), 4U);
  EXPECT_GE(found.at("order").get<double>(), 1.95);
  const double discrete = 8 * 64 * std::pow(std::sin(std::numbers::pi / 16), 2);
  EXPECT_NEAR(found.at("limit").get<double>() / discrete, 1, 1e-6);
  for (const char* file : {"convergence.csv", "convergence.h5", "convergence.png", "dt-0.001"})
    EXPECT_TRUE(fs::exists(results() + "/" + file)) << file;
}

TEST_F(Dns, FindsTheOrderOfItsGridsByFigure21) {
  const Outcome outcome =
      pennon({"dns", (source / "data/cases/flag/figure21.toml").string(), "--set",
              "dns.convergence.n=[11,15,21]", "--json", "--output", results()});
  ASSERT_EQ(outcome.status, done) << outcome.err;
  const json found = json::parse(outcome.out).at("convergence");
  EXPECT_EQ(found.at("n"), json({11, 15, 21}));
  EXPECT_GE(found.at("order").get<double>(), 1.9);
}

TEST_F(Dns, SaysWhatIsWrongWithAStudyOfConvergence) {
  const auto fault_of = [&](const std::vector<std::string>& changes) {
    std::vector<std::string> arguments = {
        "dns", (source / "data/cases/flag/figure22.toml").string(), "--check"};
    for (const std::string& change : changes) arguments.insert(arguments.end(), {"--set", change});
    const Outcome outcome = pennon(arguments);
    EXPECT_EQ(outcome.status, bad_input) << outcome.err;
    return outcome.err;
  };
  EXPECT_THAT(fault_of({"dns.convergence.n=[5,9]"}), HasSubstr("either n, to compare grids"));
  EXPECT_THAT(fault_of({"dns.convergence.dt=[0.01]"}), HasSubstr("at least two time steps"));
  EXPECT_THAT(fault_of({"dns.convergence.dt=[0.01,0.02]"}), HasSubstr("decreasing order"));
  EXPECT_THAT(fault_of({"dns.flag.equilibrium=true"}), HasSubstr("compares vibrations"));
  EXPECT_THAT(fault_of({"dns.output.history_interval=0.1"}), HasSubstr("= 0.1 leaves steps out"));
  EXPECT_THAT(fault_of({"dns.flag.trailing_edge=free"}),
              HasSubstr("a plate supported along all edges"));
  EXPECT_THAT(fault_of({"dns.initial.angle=0.1"}), HasSubstr("contradicts"));
  const Outcome early =
      pennon({"dns", (source / "data/cases/flag/figure22.toml").string(), "--set", "dns.t_end=0.1",
              "--set", "dns.n_x=5", "--set", "dns.flag.n_y=5", "--output", results()});
  EXPECT_EQ(early.status, not_converged);
  EXPECT_THAT(early.err, HasSubstr("take a longer t_end"));
}

TEST_F(Dns, RefusesAStartThatMovesAHeldEdge) {
  const auto fault_of = [&](const std::string& start, const std::string& edge) {
    const Outcome outcome =
        pennon({"dns", (source / "data/cases/flag/swinging_membrane.toml").string(), "--check",
                "--set", "dns.initial.A=[]", "--set", "dns.initial.angle=0", "--set",
                "dns.initial." + start, "--set", "dns.flag." + edge});
    EXPECT_EQ(outcome.status, bad_input) << start << edge << outcome.out;
    return outcome.err;
  };
  for (const char* held : {"pinned", "clamped"}) {
    EXPECT_THAT(fault_of("angle=0.1", std::string("trailing_edge=") + held),
                HasSubstr("dns.initial.angle moves the trailing edge"));
    EXPECT_THAT(fault_of("A=[0.1]", std::string("trailing_edge=") + held),
                HasSubstr("dns.initial.A moves the trailing edge"));
    EXPECT_THAT(fault_of("B=[0,0.1]", std::string("trailing_edge=") + held),
                HasSubstr("dns.initial.B moves the trailing edge"));
    EXPECT_THAT(fault_of("angle=0.1", std::string("side_edges=") + held),
                HasSubstr("dns.initial.angle moves the side edges"));
  }
}

TEST_F(Dns, KeepsShapesThatParaViewOpens) {
  const auto run = [&](const std::string& side_edges, const std::string& folder) {
    const Outcome outcome =
        pennon({"dns", (source / "data/cases/flag/swinging_membrane.toml").string(), "--set",
                "dns.n_x=6", "--set", "dns.flag.n_y=8", "--set", "dns.t_end=0.5", "--set",
                "dns.flag.side_edges=" + side_edges, "--output", results(folder)});
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return test::check_xdmf(results(folder) + "/shapes.xdmf");
  };
  for (const char* side_edges : {"free", "periodic"}) {
    const test::XdmfSummary found = run(side_edges, side_edges);
    EXPECT_THAT(found.times, ElementsAre(DoubleEq(0), DoubleEq(0.1), DoubleEq(0.2), DoubleEq(0.3),
                                         DoubleEq(0.4), DoubleEq(0.5)));
    EXPECT_THAT(found.attributes,
                ElementsAre("v_x: Scalar at Node", "v_y: Scalar at Node", "v_z: Scalar at Node",
                            "e_1: Scalar at Cell", "e_2: Scalar at Cell", "shear: Scalar at Cell"));
    EXPECT_THAT(found.faults, IsEmpty());
    EXPECT_TRUE(fs::exists(results(side_edges) + "/shapes_strain.png"));
  }
}

TEST_F(Pennon, ChecksEveryCaseInTheProject) {
  for (const auto& entry : fs::recursive_directory_iterator(source / "data/cases")) {
    if (entry.path().extension() != ".toml") continue;
    const std::string folder = entry.path().parent_path().filename().string();
    const bool is_simulated = folder == "flag" || folder == "fluid" || folder == "coupled";
    const std::string command = folder == "modes" ? "modes" : is_simulated ? "dns" : "lsa";
    const Outcome outcome = pennon({command, entry.path().string(), "--check"});
    EXPECT_EQ(outcome.status, done) << entry.path() << outcome.err;
  }
}

TEST_F(Pennon, HasAReferenceOfTheCaseFileInStepWithTheCode) {
  const Outcome outcome = pennon({"reference"});
  EXPECT_EQ(outcome.status, done);
  EXPECT_EQ(outcome.out, test::read_text(source / "docs/case-file.md"))
      << "run: pennon reference > docs/case-file.md";
}

TEST_F(Pennon, DrawsAnOutputFileAgain) {
  ASSERT_EQ(pennon({"lsa", (source / "data/cases/figures/figure4b.toml").string(), "--quiet",
                    "--output", results()})
                .status,
            done);
  fs::remove(results() + "/curve.png");
  EXPECT_EQ(pennon({"plot", results() + "/curve.h5"}).status, done);
  EXPECT_TRUE(fs::exists(results() + "/curve.png"));
  const Outcome wrong = pennon({"plot", case_of("C2D")});
  EXPECT_EQ(wrong.status, bad_input);
  EXPECT_THAT(wrong.err, HasSubstr("is not an HDF5 file"));
}

TEST_F(Pennon, AnswersVersionHelpAndNonsense) {
  EXPECT_THAT(pennon({"--version"}).out, HasSubstr("commit"));
  EXPECT_THAT(pennon({"lsa", "--help"}).out, HasSubstr("Example: pennon lsa"));
  EXPECT_EQ(pennon({}).status, bad_input);
  EXPECT_EQ(pennon({"frobnicate"}).status, bad_input);
  EXPECT_EQ(pennon({"lsa", case_of("C2D"), "--set", "nonsense"}).status, bad_input);
}

}  // namespace
}  // namespace pennon

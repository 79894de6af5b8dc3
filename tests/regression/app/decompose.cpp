/// pennon decompose on a run and on the files of other codes, as a user starts it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>

#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/held_snapshots.hpp"

namespace pennon {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::bad_input;
using test::done;
using test::Outcome;
using testing::HasSubstr;
using Complex = std::complex<double>;
using Words = std::vector<std::string>;

class Decompose : public test::Commands {
 protected:
  std::string file() const { return (folder_ / "snapshots.h5").string(); }
  // Two waves that travel, with noise: 150 snapshots of 60 values.
  void write_waves() const {
    constexpr Eigen::Index M = 150, values = 60;
    const std::vector<double> t = test::steps(M, 0.1);
    Eigen::MatrixXd q = 0.01 * test::NormalNumbers(1).matrix(values, M);
    for (Eigen::Index m = 0; m < M; ++m)
      for (Eigen::Index i = 0; i < values; ++i) {
        const double x = static_cast<double>(i) / values, time = t[static_cast<std::size_t>(m)];
        q(i, m) +=
            std::cos(5 * x - 4 * time) * std::exp(0.05 * time) + 0.3 * std::cos(3 * x + 9 * time);
      }
    hdf5::Writer writer(file());
    writer.write("/t", {static_cast<hsize_t>(M)}, t);
    writer.write("/q", {static_cast<hsize_t>(M), static_cast<hsize_t>(values)},
                 {q.data(), static_cast<std::size_t>(q.size())});
    writer.finish();
  }
  static Words with(Words words, const Words& settings) {
    for (const std::string& setting : settings) {
      words.emplace_back("--set");
      words.push_back("decompose." + setting);
    }
    return words;
  }
  // What the command says of a source, in the folder `name`.
  json decomposed(const std::string& data, const Words& settings, const std::string& name) {
    const Outcome outcome =
        pennon(with({"decompose", data, "--json", "--output", results(name)}, settings));
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return outcome.status == done ? json::parse(outcome.out).at("decompose") : json();
  }
  void expect_fault(const Words& settings, const std::string& sentence) {
    const Outcome outcome =
        pennon(with({"decompose", file(), "--output", results("fault")}, settings));
    EXPECT_EQ(outcome.status, bad_input) << sentence;
    EXPECT_THAT(outcome.err, HasSubstr(sentence));
    EXPECT_FALSE(fs::exists(results("fault"))) << sentence;
  }
};

TEST_F(Decompose, FindsProperOrthogonalModes) {
  write_waves();
  const json found = decomposed(file(), {"n_modes=4"}, "pod");
  EXPECT_EQ(found.at("method"), "pod");
  EXPECT_EQ(found.at("snapshots"), 150);
  EXPECT_EQ(found.at("values"), 60);
  ASSERT_EQ(found.at("energy").size(), 4U);
  double together = 0;
  for (const json& share : found.at("share")) together += share.get<double>();
  EXPECT_GT(together, 0.999) << "two waves are four modes";
  for (const char* name :
       {"decomposition.h5", "decomposition.csv", "decomposition.png",
        "decomposition_coefficients.svg", "summary.json", "record.json", "case.resolved.toml"})
    EXPECT_TRUE(fs::exists(fs::path(results("pod")) / name)) << name;
  const hdf5::Reader modes(results("pod") + "/decomposition.h5");
  EXPECT_EQ(modes.shape("/modes"), (hdf5::Shape{4, 1, 60}));
  EXPECT_EQ(modes.shape("/coefficients"), (hdf5::Shape{4, 150}));
  // With the mean the modes are the data but for what four modes leave.
  const std::vector<double> mean = modes.read("/mean", {1, 1, 60}).values,
                            phi = modes.read("/modes").values,
                            a = modes.read("/coefficients").values;
  EXPECT_EQ(modes.read("/weight", {1, 1, 60}).values, std::vector<double>(60, 1.0));
  const std::vector<double> q = hdf5::Reader(file()).read("/q").values;
  double largest = 0;
  for (std::size_t m = 0; m < 150; ++m)
    for (std::size_t i = 0; i < 60; ++i) {
      double sum = mean[i];
      for (std::size_t j = 0; j < 4; ++j) sum += a[j * 150 + m] * phi[j * 60 + i];
      largest = std::max(largest, std::abs(sum - q[m * 60 + i]));
    }
  EXPECT_LT(largest, 0.06) << "of noise of 0.01 in each value";
}

TEST_F(Decompose, FindsDynamicModes) {
  write_waves();
  for (const char* variant : {"variant=exact", "variant=optimised"}) {
    const json found = decomposed(file(), {"method=dmd", variant}, variant);
    EXPECT_EQ(found.at("rank"), 4) << variant;
    ASSERT_EQ(found.at("modes").size(), 2U) << "one of each pair";
    const json& first = found.at("modes")[0];
    EXPECT_NEAR(first.at("growth"), 0.05, 4 * first.at("growth_error").get<double>() + 1e-4)
        << variant;
    EXPECT_NEAR(first.at("omega"), 4, 4 * first.at("omega_error").get<double>()) << variant;
    EXPECT_NEAR(found.at("modes")[1].at("omega"), 9, 0.01) << variant;
  }
}

TEST_F(Decompose, FindsSpectralModes) {
  write_waves();
  const json found = decomposed(file(), {"method=spod", "block=50", "n_modes=2"}, "spod");
  EXPECT_EQ(found.at("blocks"), 5);
  ASSERT_EQ(found.at("f").size(), 26U);
  ASSERT_EQ(found.at("energy").size(), 26U);
  EXPECT_EQ(found.at("energy")[0].size(), 2U);
  EXPECT_NEAR(found.at("peaks")[0], 4 / (2 * M_PI), 0.1);
  for (std::size_t k = 0; k < 26; ++k) {
    EXPECT_LT(found.at("interval")[k][0], found.at("energy")[k][0]);
    EXPECT_GT(found.at("interval")[k][1], found.at("energy")[k][0]);
  }
  const CsvTable table(results("spod") + "/decomposition.csv");
  EXPECT_EQ(table.rows(), 26U);
}

TEST_F(Decompose, FindsTheSameOnSeveralRanks) {
  write_waves();
  for (const std::string method : {"pod", "dmd", "spod"}) {
    const Words settings = {"method=" + method, "block=30", "n_modes=2", "from=0", "to=5"};
    const json alone = decomposed(file(), settings, method);
    const Outcome outcome = pennon_on(
        2, with({"decompose", file(), "--json", "--output", results(method + "_2")}, settings));
    ASSERT_EQ(outcome.status, done) << outcome.err;
    const json together = json::parse(outcome.out).at("decompose");
    EXPECT_NEAR(together.at("variance").get<double>() / alone.at("variance").get<double>(), 1,
                1e-12);
    const hdf5::Reader one(results(method) + "/decomposition.h5"),
        two(results(method + "_2") + "/decomposition.h5");
    const char* array = method == "pod" ? "/modes" : "/modes_real";
    const std::vector<double> a = one.read(array).values, b = two.read(array).values;
    ASSERT_EQ(a.size(), b.size());
    // The first mode, but for its sign.
    double same = 0, turned = 0;
    for (std::size_t i = 0; i < 60; ++i) {
      same = std::max(same, std::abs(a[i] - b[i]));
      turned = std::max(turned, std::abs(a[i] + b[i]));
    }
    EXPECT_LT(std::min(same, turned), 1e-9) << method;
  }
}

TEST_F(Decompose, SaysWhatIsWrongAndWritesNothing) {
  write_waves();
  expect_fault({"method=\"powd\""}, "must be one of \"pod\", \"dmd\", \"spod\", \"waves\"");
  expect_fault({"n_modes=61"}, "decompose.n_modes = 61 is more than the 60 there are");
  expect_fault({"method=spod", "block=151"},
               "decompose.block = 151 is more than the 150 snapshots");
  expect_fault({"method=spod", "n_modes=9", "block=100"},
               "decompose.n_modes = 9 is more than the 2 there are: 2 blocks");
  expect_fault({"method=dmd", "rank=61"}, "decompose.rank = 61 is above 60");
  expect_fault({"from=3", "to=3.04"}, "and 1 from 3 to 3.04");
  expect_fault({"from=5", "to=2"}, "decompose.to = 2 must be above decompose.from = 5");
  expect_fault({"method=waves"}, "is of a flag, and");
  expect_fault({"wave=1"}, "decompose.wave = 1 needs a span");
  expect_fault({"memory=\"2 apples\""}, "decompose.memory = \"2 apples\" is no size; \"2GB\"");
  expect_fault({"memory=\"1kB\""}, "is too little for 150 snapshots");
  expect_fault({"method=spod", "frequencies=[7.0]"},
               "decompose.frequencies has 7, and those of the snapshots");
  const Outcome foreign_key = pennon({"decompose", file(), "--set", "flag.mu=1"});
  EXPECT_EQ(foreign_key.status, bad_input);
  EXPECT_THAT(foreign_key.err, HasSubstr("which takes decompose.key=value"));
  const Outcome nothing = pennon({"decompose", (folder_ / "nowhere").string()});
  EXPECT_EQ(nothing.status, bad_input);
  EXPECT_THAT(nothing.err, HasSubstr("there is no such file or folder"));
}

TEST_F(Decompose, ReplacesNoOtherResultUnasked) {
  write_waves();
  decomposed(file(), {}, "same");
  EXPECT_EQ(pennon({"decompose", file(), "--output", results("same")}).status, done);
  const Outcome refused =
      pennon(with({"decompose", file(), "--output", results("same")}, {"method=spod"}));
  EXPECT_EQ(refused.status, bad_input);
  EXPECT_THAT(refused.err, HasSubstr("decompose.method = 'pod' there, 'spod' here"));
  EXPECT_EQ(
      pennon(with({"decompose", file(), "--force", "--output", results("same")}, {"method=spod"}))
          .status,
      done);
}

// A run that starts as a global mode: its dynamic mode is that mode.
class DecomposeRun : public Decompose {
 protected:
  static constexpr const char* case_text =
      "[flag]\nmu = 0.3\nK_B = 1e-3\ndamping = 0.02\n[flow]\nRe = 300\n"
      "[dns]\nn_rho = 16\nn_theta = 32\nR = 4\nwall_spacing = 0.05\ndt = 0.005\nt_end = 4\n"
      "[dns.output]\nshape_interval = 0.04\nfield_interval = 0.2\n"
      "[modes.global]\nn_modes = 1\ntarget = [0.43, 2.62]\n";

  // The run beside its mode.
  void run() {
    const std::string modes = test::write_text(folder_ / "modes.toml", case_text).string();
    ASSERT_EQ(pennon({"modes", modes, "--quiet", "--output", results("modes")}).status, done);
    const std::string file =
        test::write_text(folder_ / "run.toml",
                         std::string(case_text) + "[dns.initial]\nglobal_modes = \"" +
                             results("modes") + "/global_modes.h5\"\nmode_amplitude = 1e-3\n")
            .string();
    ASSERT_EQ(pennon({"dns", file, "--quiet", "--output", results("run")}).status, done);
  }
};

TEST_F(DecomposeRun, FindsTheGlobalModeInItsLinearPhase) {
  ASSERT_NO_FATAL_FAILURE(run());
  const CsvTable table(results("modes") + "/global_modes.csv");
  const Complex lambda(table.numbers("growth").front(), table.numbers("omega").front());
  // The simulation differs from the eigenvalue by the square of its step.
  const double bound = 1e-3 * std::abs(lambda);
  const json found =
      decomposed(results("run"), {"method=dmd", "variant=optimised", "rank=2", "from=0.5"}, "dmd");
  const json& mode = found.at("modes")[0];
  EXPECT_LT(std::abs(Complex(mode.at("growth"), mode.at("omega")) - lambda), bound);

  // Its shape is the mode's: the angle between the two is below a degree.
  const hdf5::Reader dynamic(results("dmd") + "/decomposition.h5"),
      global(results("modes") + "/global_modes.h5");
  const std::vector<double> y = global.list("/y");
  const std::vector<double> real = dynamic.read("/modes_real").values,
                            imaginary = dynamic.read("/modes_imag").values;
  const std::vector<double> zeta_real = global.list("/mode_1/zeta_real"),
                            zeta_imag = global.list("/mode_1/zeta_imag");
  // Both modes of the pair are there, one with the frequency of the global mode.
  const std::size_t begin = dynamic.list("/omega")[0] > 0 ? 0 : y.size();
  Complex product = 0;
  double of_dynamic = 0, of_global = 0;
  for (std::size_t j = 0; j < y.size(); ++j) {
    const Complex a(real[begin + j], imaginary[begin + j]), b(zeta_real[j], zeta_imag[j]);
    product += std::conj(a) * b;
    of_dynamic += std::norm(a);
    of_global += std::norm(b);
  }
  EXPECT_GT(std::abs(product) / std::sqrt(of_dynamic * of_global), std::cos(M_PI / 180));

  // The amplitude on the mode grows and turns as the eigenvalue says, and nothing else is there.
  const json projected = decomposed(
      results("run"),
      {"method=global_modes", "global_modes=" + results("modes") + "/global_modes.h5", "from=0.5"},
      "projected");
  const json& on_mode = projected.at("modes")[0];
  EXPECT_LT(projected.at("error"), 1e-3);
  EXPECT_LT(std::abs(Complex(on_mode.at("growth"), on_mode.at("omega")) - lambda), bound);
  EXPECT_NEAR(on_mode.at("growth_of_mode"), lambda.real(), 1e-12);

  // In the fluid the mode stands beside the steady flow, which does not change.
  const json of_fluid =
      decomposed(results("run"), {"method=dmd", "of=fluid", "from=0.5"}, "fluid").at("modes");
  EXPECT_NEAR(of_fluid[0].at("growth"), 0, 1e-6);
  EXPECT_NEAR(of_fluid[0].at("omega"), 0, 1e-6);
  EXPECT_NEAR(of_fluid[1].at("growth"), lambda.real(), 0.02 * lambda.imag());
  EXPECT_NEAR(of_fluid[1].at("omega"), lambda.imag(), 0.02 * lambda.imag());
}

}  // namespace
}  // namespace pennon

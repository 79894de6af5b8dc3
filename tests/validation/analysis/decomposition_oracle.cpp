/// pennon decompose against NumPy on the same files (tests/support/decomposition_oracle.py).
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/held_snapshots.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using test::done;
using test::Outcome;
using Words = std::vector<std::string>;

// Both round their sums in another order.
constexpr double bound = 1e-10;

class AgainstNumPy : public test::Commands {
 protected:
  // Waves that grow and decay, in noise, at 90 points of two components with weights that change.
  std::string write_waves() const {
    constexpr Eigen::Index M = 260, points = 90;
    const std::vector<double> t = test::steps(M, 0.07);
    test::NormalNumbers random(1);
    Eigen::MatrixXd q = 0.02 * random.matrix(2 * points, M);
    for (Eigen::Index m = 0; m < M; ++m)
      for (Eigen::Index i = 0; i < 2 * points; ++i) {
        const double x = static_cast<double>(i) / points, time = t[static_cast<std::size_t>(m)];
        q(i, m) += std::cos(4 * x - 3 * time) * std::exp(0.03 * time) +
                   0.4 * std::cos(7 * x + 8 * time) * std::exp(-0.02 * time) + 1;
      }
    const Eigen::MatrixXd weight = random.matrix(points, M).cwiseAbs();
    std::string path = (folder_ / "waves.h5").string();
    hdf5::Writer file(path);
    file.write("/t", {static_cast<hsize_t>(M)}, t);
    file.write("/q", {static_cast<hsize_t>(M), 2, static_cast<hsize_t>(points)},
               {q.data(), static_cast<std::size_t>(q.size())});
    file.write("/weight", {static_cast<hsize_t>(M), static_cast<hsize_t>(points)},
               {weight.data(), static_cast<std::size_t>(weight.size())});
    file.finish();
    return path;
  }
  json of_pennon(const std::string& path, const Words& settings) {
    Words words = {"decompose", path, "--json", "--force", "--output", results("pennon")};
    for (const std::string& setting : settings) {
      words.emplace_back("--set");
      words.push_back("decompose." + setting);
    }
    const Outcome outcome = pennon(words);
    EXPECT_EQ(outcome.status, done) << outcome.err;
    return json::parse(outcome.out).at("decompose");
  }
  json of_numpy(const std::string& path, const std::string& method, const Words& keys) {
    Words words = {"/usr/bin/python3",
                   (test::source / "tests/support/decomposition_oracle.py").string(), path, method};
    words.insert(words.end(), keys.begin(), keys.end());
    const Outcome outcome =
        finish(test::start_program(words, folder_ / "out.txt", folder_ / "err.txt"));
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return json::parse(outcome.out);
  }
  static void expect_equal(const json& found, const json& expected, const std::string& what) {
    double largest = 0, difference = 0;
    for (std::size_t k = 0; k < found.size(); ++k) {
      largest = std::max(largest, std::abs(expected[k].get<double>()));
      difference =
          std::max(difference, std::abs(found[k].get<double>() - expected[k].get<double>()));
    }
    EXPECT_GT(found.size(), 0U) << what;
    EXPECT_LT(difference, bound * largest) << what;
  }
};

TEST_F(AgainstNumPy, ProperOrthogonalEnergiesAreTheSame) {
  const std::string path = write_waves();
  for (const std::string mean : {"mean=removed", "mean=kept"})
    expect_equal(of_pennon(path, {"method=pod", "n_modes=40", mean}).at("energy"),
                 of_numpy(path, "pod", {mean}).at("energy"), mean);
}

TEST_F(AgainstNumPy, SpectralEnergiesAreTheSame) {
  const std::string path = write_waves();
  for (const Words& keys : {Words{"block=64", "overlap=0.5", "window=hamming"},
                            Words{"block=51", "overlap=0.75", "window=hann"},
                            Words{"block=32", "overlap=0", "window=none"}}) {
    Words settings = keys;
    settings.emplace_back("method=spod");
    const json found = of_pennon(path, settings), expected = of_numpy(path, "spod", keys);
    EXPECT_EQ(found.at("blocks"), expected.at("blocks"));
    expect_equal(found.at("f"), expected.at("f"), keys[0]);
    for (std::size_t f = 0; f < found.at("f").size(); ++f)
      expect_equal(found.at("energy")[f], expected.at("energy")[f],
                   fmt::format("{}, f {}", keys[0], f));
  }
}

TEST_F(AgainstNumPy, DynamicModesAreTheSame) {
  const std::string path = write_waves();
  const json modes = of_pennon(path, {"method=dmd", "rank=5"}).at("modes"),
             expected = of_numpy(path, "dmd", {"rank=5"});
  ASSERT_EQ(expected.at("growth").size(), 5U);
  // pennon tells one of each pair.
  EXPECT_EQ(modes.size(), 3U);
  for (const json& mode : modes) {
    double nearest = INFINITY;
    for (std::size_t k = 0; k < 5; ++k)
      nearest = std::min(
          nearest,
          std::abs(mode.at("growth").get<double>() - expected.at("growth")[k].get<double>()) +
              std::abs(mode.at("omega").get<double>() - expected.at("omega")[k].get<double>()) +
              std::abs(mode.at("amplitude").get<double>() -
                       expected.at("amplitude")[k].get<double>()) /
                  mode.at("amplitude").get<double>());
    EXPECT_LT(nearest, bound) << mode;
  }
}

}  // namespace
}  // namespace pennon

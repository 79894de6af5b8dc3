/// Displacements as sums of modes, from functions and from samples.
#include "modes/normal/decomposition.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <numbers>
#include <random>

#include "common/errors.hpp"
#include "modes/normal/gauss_legendre.hpp"
#include "tests/support/mode_families.hpp"

namespace pennon::modes {
namespace {

using test::families;
using test::flag;
using test::flow;
using ::testing::HasSubstr;

// Of sums of some ten thousand terms of the order of 1.
constexpr double roundoff = 1e-12;

std::vector<Amplitude> some_amplitudes(const NormalModes& family) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> amplitude(-1, 1);
  std::vector<Amplitude> amplitudes;
  for (const NormalMode& mode : family.modes)
    amplitudes.push_back({mode.n, mode.m, amplitude(random), mode.n > 0 ? amplitude(random) : 0});
  return amplitudes;
}

Displacement sum_of(const NormalModes& family, const std::vector<Amplitude>& amplitudes) {
  return
      [&family, amplitudes](double x, double y) { return displacement(family, amplitudes, x, y); };
}

std::vector<Sample> scattered(const Displacement& zeta, int count) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<Sample> samples;
  for (int i = 0; i < count; ++i) {
    const double x = 2 * unit(random);
    const double y = unit(random);
    samples.push_back({x, y, zeta(x, y)});
  }
  return samples;
}

void expect_equal(const std::vector<Amplitude>& found, const std::vector<Amplitude>& expected,
                  double tolerance) {
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].n, expected[i].n);
    EXPECT_EQ(found[i].m, expected[i].m);
    EXPECT_NEAR(found[i].A, expected[i].A, tolerance) << "n = " << found[i].n;
    EXPECT_NEAR(found[i].B, expected[i].B, tolerance) << "n = " << found[i].n;
  }
}

TEST(Decomposition, OfASumOfModesGivesItsAmplitudesAndLeavesNothing) {
  for (const NormalModes& family : families({{0, 1, 3}, 4}, 80)) {
    const std::vector<Amplitude> amplitudes = some_amplitudes(family);
    const Decomposition result = decompose(family, sum_of(family, amplitudes));
    expect_equal(result.amplitudes, amplitudes, roundoff);
    EXPECT_LT(result.truncation_error, roundoff);
    EXPECT_FALSE(result.fit.has_value());
  }
}

TEST(Decomposition, OfSamplesOfASumGivesTheSameAmplitudes) {
  for (const NormalModes& family : families({{0, 1, 3}, 4}, 80)) {
    const std::vector<Amplitude> amplitudes = some_amplitudes(family);
    const std::vector<Sample> samples = scattered(sum_of(family, amplitudes), 300);
    const Decomposition result = decompose(family, samples, "samples");
    expect_equal(result.amplitudes, amplitudes, roundoff * result.fit->condition_number);
    EXPECT_LT(result.truncation_error, roundoff);
    EXPECT_EQ(result.fit->samples, 300u);
    EXPECT_EQ(result.fit->unknowns, 20);
    EXPECT_LT(result.fit->condition_number, 10);
  }
}

TEST(Decomposition, KeepsTheSumOfSquares) {
  // Parseval: the mean over the span of the integral of w zeta^2 is the sum of norm^2 A^2 for n = 0
  // and of norm^2 (A^2 + B^2)/2 for n > 0.
  for (const NormalModes& family : families({{0, 2}, 5}, 80)) {
    const std::vector<Amplitude> amplitudes = some_amplitudes(family);
    double by_modes = 0;
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      const auto& [n, m, A, B] = amplitudes[i];
      by_modes += family.modes[i].norm_squared * (A * A + B * B) / (n > 0 ? 2 : 1);
    }
    double by_points = 0;
    constexpr int columns = 16;
    for (const QuadraturePoint& point : gauss_legendre(family.panels))
      for (int j = 0; j < columns; ++j) {
        const double zeta = displacement(family, amplitudes, 2.0 * j / columns, point.y);
        by_points += point.weight * family.weight(point.y) * zeta * zeta / columns;
      }
    EXPECT_NEAR(by_points / by_modes, 1, roundoff);
  }
}

TEST(Decomposition, LeavesLessTheMoreModesItMayUse) {
  const auto zeta = [](double x, double y) {
    return y * (1.2 - y) * (1 + 0.3 * std::cos(3.14 * x));
  };
  std::vector<double> before(3, 1.0);
  for (const int m : {1, 2, 4, 8, 16}) {
    const std::vector<NormalModes> all = families({{0, 1, 2}, m}, 80);
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double error = decompose(all[i], zeta).truncation_error;
      EXPECT_LT(error, before[i]) << "family " << i << ", m = " << m;
      before[i] = error;
    }
  }
}

// Fourier and Bessel's series with s = 1-y and the weight w = s: the integral of w s^n J_n(alpha s)
// is J_(n+1)(alpha)/alpha, so that 1 + (a cos + b sin)(k_x x) s has the amplitudes 2/(alpha
// J_(n+1)(alpha)) times 1 for n = 0 and a, b for n = 1. Each mode takes 2/alpha^2 times their
// squares from the squared norm, 1/2 + (a^2 + b^2)/8, and half of that for n = 1.
TEST(Decomposition, OfPowersIsFourierAndBesselsSeriesAndItsRemainder) {
  constexpr double a = 0.7, b = -0.4;
  constexpr int modes = 5;
  const NormalModes family = bessel_modes({{0, 1}, modes}, flag(), flow);
  const double k_x = 2 * std::numbers::pi / *flag().gamma;
  const Decomposition result = decompose(family, [&](double x, double y) {
    return 1 + (a * std::cos(k_x * x) + b * std::sin(k_x * x)) * (1 - y);
  });
  std::vector<Amplitude> exact;
  const double whole = 0.5 + (a * a + b * b) / 8;
  double rest = whole;
  for (const int n : {0, 1})
    for (int m = 1; m <= modes; ++m) {
      const double alpha = boost::math::cyl_bessel_j_zero(static_cast<double>(n), m);
      const double amplitude = 2 / (alpha * boost::math::cyl_bessel_j(n + 1, alpha));
      const double square = 2 / (alpha * alpha);
      exact.push_back({n, m, n == 0 ? amplitude : a * amplitude, n == 0 ? 0 : b * amplitude});
      rest -= n == 0 ? square : (a * a + b * b) / 2 * square;
    }
  expect_equal(result.amplitudes, exact, roundoff);
  EXPECT_NEAR(result.truncation_error, std::sqrt(rest / whole), roundoff);
  EXPECT_GT(result.truncation_error, 0.1);
}

// The amplitudes a of a weighted fit solve M^T W M a = M^T W zeta, for what lies outside of the
// span of the modes too.
struct NormalEquations {
  Eigen::MatrixXd M;
  Eigen::VectorXd zeta, w;

  NormalEquations(const NormalModes& family, const std::vector<Sample>& samples)
      : M(samples.size(), 2 * family.modes.size()), zeta(samples.size()), w(samples.size()) {
    for (Eigen::Index i = 0; i < M.rows(); ++i) {
      const Sample& at = samples[static_cast<std::size_t>(i)];
      zeta[i] = at.zeta;
      w[i] = family.weight(at.y);
      for (std::size_t k = 0; k < family.modes.size(); ++k) {
        const NormalMode& mode = family.modes[k];
        const auto column = static_cast<Eigen::Index>(2 * k);
        M(i, column) = mode.shape(at.y) * std::cos(mode.k_x * at.x);
        M(i, column + 1) = mode.shape(at.y) * std::sin(mode.k_x * at.x);
      }
    }
  }
  // A, B in turn; B = 0 for n = 0, where its column vanishes.
  Eigen::VectorXd solve() const {
    const Eigen::MatrixXd normal = M.transpose() * w.asDiagonal() * M;
    return normal.completeOrthogonalDecomposition().solve(M.transpose() * w.cwiseProduct(zeta));
  }
  double truncation_error(const Eigen::VectorXd& a) const {
    const Eigen::VectorXd rest = zeta - M * a;
    return std::sqrt(w.dot(rest.cwiseAbs2()) / w.dot(zeta.cwiseAbs2()));
  }
};

TEST(Decomposition, OfSamplesWithARemainderSolvesTheWeightedNormalEquations) {
  const auto zeta = [](double x, double y) {
    return std::exp(-3 * y) * (1 + 0.5 * std::sin(3.1 * x)) + 0.2 * std::cos(9 * x);
  };
  double unlike_without_weights = 0;
  for (const NormalModes& family : families({{0, 1, 3}, 3}, 80)) {
    const std::vector<Sample> samples = scattered(zeta, 200);
    const Decomposition result = decompose(family, samples, "samples");
    NormalEquations equations(family, samples);
    const Eigen::VectorXd exact = equations.solve();
    const double tolerance = roundoff * std::pow(result.fit->condition_number, 2);
    std::vector<Amplitude> amplitudes;
    for (std::size_t k = 0; k < family.modes.size(); ++k) {
      const auto column = static_cast<Eigen::Index>(2 * k);
      amplitudes.push_back(
          {family.modes[k].n, family.modes[k].m, exact[column], exact[column + 1]});
    }
    expect_equal(result.amplitudes, amplitudes, tolerance);
    EXPECT_NEAR(result.truncation_error, equations.truncation_error(exact), roundoff);
    EXPECT_GT(result.truncation_error, 0.1);
    equations.w.setOnes();
    unlike_without_weights =
        std::max(unlike_without_weights, (equations.solve() - exact).cwiseAbs().maxCoeff());
  }
  EXPECT_GT(unlike_without_weights, 0.01) << "the weights matter too little for this test";
}

TEST(Decomposition, InTwoDimensionsHasNoSpan) {
  FlagParameters plane = flag();
  plane.gamma.reset();
  const NormalModes family = hanging_chain_modes({{0}, 5}, plane, flow);
  const std::vector<Amplitude> amplitudes = some_amplitudes(family);
  const Displacement zeta = sum_of(family, amplitudes);
  expect_equal(decompose(family, zeta).amplitudes, amplitudes, roundoff);
  std::vector<Sample> samples;
  for (int i = 1; i <= 40; ++i) samples.push_back({0, i / 40.0, zeta(0, i / 40.0)});
  expect_equal(decompose(family, samples, "samples").amplitudes, amplitudes, roundoff);
}

TEST(Decomposition, OfRestIsRest) {
  const NormalModes family = bessel_modes({{0, 1}, 2}, flag(), flow);
  const Decomposition result = decompose(family, [](double, double) { return 0.0; });
  EXPECT_EQ(result.truncation_error, 0);
  for (const Amplitude& amplitude : result.amplitudes) EXPECT_EQ(amplitude.A, 0);
}

std::string refusal(const NormalModes& family, const std::vector<Sample>& samples) {
  try {
    decompose(family, samples, "wave.csv");
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(Decomposition, OfFewerSamplesThanAmplitudesIsRefused) {
  const NormalModes family = bessel_modes({{0, 1}, 3}, flag(), flow);
  EXPECT_THAT(refusal(family, scattered([](double, double y) { return y; }, 8)),
              HasSubstr("wave.csv: has 8 samples for 9 unknown amplitudes"));
}

TEST(Decomposition, OfSamplesThatCannotTellModesApartIsRefused) {
  const NormalModes family = bessel_modes({{0, 1}, 2}, flag(), flow);
  std::vector<Sample> in_one_line;
  in_one_line.reserve(50);
  for (int i = 0; i < 50; ++i) in_one_line.push_back({0.5, i / 50.0, 0.1});
  EXPECT_THAT(refusal(family, in_one_line), HasSubstr("wave.csv: the 50 samples determine only"));
}

}  // namespace
}  // namespace pennon::modes

#include "analysis/decomposition/dmd.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/held_snapshots.hpp"

namespace pennon::decomposition {
namespace {

using namespace pennon::test;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double dt = 0.1;

// sum_j B_j exp(lambda_j t_m): values x M.
MatrixXcd exponentials(const VectorXcd& lambda, const MatrixXcd& B, Index M) {
  MatrixXcd q = MatrixXcd::Zero(B.rows(), M);
  for (Index m = 0; m < M; ++m)
    for (Index j = 0; j < lambda.size(); ++j)
      q.col(m) += B.col(j) * std::exp(lambda(j) * dt * static_cast<double>(m));
  return q;
}

// The modes by their angular frequencies.
std::vector<DmdMode> sorted(const Dmd& found) {
  std::vector<DmdMode> modes = found.modes;
  std::ranges::sort(modes, {}, [](const DmdMode& mode) { return mode.lambda.imag(); });
  return modes;
}

struct KnownSum {
  VectorXcd lambda = VectorXcd{{Complex(0.1, -3), Complex(-0.4, 1), Complex(-0.05, 7)}};
  MatrixXcd B = NormalNumbers(1).complex_matrix(12, 3);
};

void expect_exact(DmdVariant variant) {
  const KnownSum known;
  const MatrixXcd q = exponentials(known.lambda, known.B, 60);
  const Dmd found = dmd<Complex>(q, dt, 12, {variant, {}});
  ASSERT_EQ(found.rank, 3);
  const auto modes = sorted(found);
  for (Index j = 0; j < 3; ++j) {
    const DmdMode& mode = modes[static_cast<std::size_t>(j)];
    EXPECT_LT(std::abs(mode.lambda - known.lambda(j)), 1e-10) << j;
    EXPECT_NEAR(mode.amplitude, known.B.col(j).norm(), 1e-9) << j;
    EXPECT_LT(mode.residual, 1e-10) << j;
    EXPECT_LT(mode.growth_error + mode.omega_error, 1e-9) << j;
  }
  // With amplitudes and phases of the first snapshot the modes add up to the data.
  const MatrixXcd phi = q * found.combination;
  VectorXcd lambda(3);
  MatrixXcd B(12, 3);
  for (Index j = 0; j < 3; ++j) {
    lambda(j) = found.modes[static_cast<std::size_t>(j)].lambda;
    B.col(j) = phi.col(j) * found.modes[static_cast<std::size_t>(j)].amplitude;
  }
  EXPECT_LT((exponentials(lambda, B, 60) - q).norm() / q.norm(), 1e-9);
}

TEST(ExactDmd, FindsASumOfExponentials) {
  expect_exact(DmdVariant::exact);
}

TEST(OptimisedDmd, FindsASumOfExponentials) {
  expect_exact(DmdVariant::optimised);
}

TEST(Dmd, FindsPairsInRealData) {
  const MatrixXcd B = NormalNumbers(2).complex_matrix(30, 2);
  const MatrixXd q = exponentials(VectorXcd{{Complex(0.2, 5), Complex(-0.3, 9)}}, B, 80).real();
  for (const DmdVariant variant : {DmdVariant::exact, DmdVariant::optimised}) {
    const auto modes = sorted(dmd<double>(q, dt, 30, {variant, {}}));
    ASSERT_EQ(modes.size(), 4U);
    EXPECT_LT(std::abs(modes[3].lambda - Complex(-0.3, 9)), 1e-10);
    EXPECT_LT(std::abs(modes[2].lambda - Complex(0.2, 5)), 1e-10);
    EXPECT_LT(std::abs(modes[1].lambda - Complex(0.2, -5)), 1e-10);
  }
}

// White noise of variance s^2 in each value adds s^2 to the mean square of the one coordinate in
// which the mode lies, and nothing to the product of two snapshots: theta falls by 1/(1 + s^2).
TEST(ExactDmd, DecaysByNoiseAsMuchAsTheorySays) {
  constexpr Index values = 8, M = 2000;
  constexpr double s = 0.3;
  const Complex lambda(0, 2);
  const MatrixXcd q = exponentials(VectorXcd::Constant(1, lambda),
                                   MatrixXcd::Constant(values, 1, 1 / std::sqrt(values)), M);
  double mean = 0;
  constexpr int draws = 20;
  for (unsigned draw = 0; draw < draws; ++draw) {
    const MatrixXcd noisy = q + s * NormalNumbers(draw).complex_matrix(values, M);
    mean +=
        dmd<Complex>(noisy, dt, values, {DmdVariant::exact, 1}).modes.front().lambda.real() / draws;
  }
  const double theory = -std::log(1 + s * s) / dt;
  EXPECT_NEAR(mean / theory, 1, 0.03);
}

// Cramer and Rao's bound of the variance of growth and frequency: of the real parameters of all
// exponentials and their modes, in complex white noise of variance s^2.
VectorXd least_deviations(const VectorXcd& lambda, const MatrixXcd& B, Index M, double s) {
  const Index values = B.rows(), count = lambda.size();
  MatrixXd J = MatrixXd::Zero(2 * values * M, 2 * count * (1 + values));
  for (Index m = 0; m < M; ++m)
    for (Index i = 0; i < values; ++i)
      for (Index j = 0; j < count; ++j) {
        const double t = dt * static_cast<double>(m);
        const Complex wave = std::exp(lambda(j) * t), by_lambda = B(i, j) * t * wave;
        const Index row = 2 * (m * values + i), column = 2 * j, of_B = 2 * (count + i * count + j);
        J(row, column) = by_lambda.real();
        J(row + 1, column) = by_lambda.imag();
        J(row, column + 1) = -by_lambda.imag();
        J(row + 1, column + 1) = by_lambda.real();
        J(row, of_B) = wave.real();
        J(row + 1, of_B) = wave.imag();
        J(row, of_B + 1) = -wave.imag();
        J(row + 1, of_B + 1) = wave.real();
      }
  const MatrixXd covariance = (J.transpose() * J).inverse() * (s * s / 2);
  return covariance.diagonal().head(2 * count).cwiseSqrt();
}

TEST(OptimisedDmd, IsAsCertainAsCramerAndRaoAllowInNoise) {
  const VectorXcd lambda{{Complex(0.02, 5), Complex(-0.1, 8)}};
  const MatrixXcd B = NormalNumbers(3).complex_matrix(6, 2);
  constexpr Index M = 80;
  constexpr double s = 0.1;
  const MatrixXcd q = exponentials(lambda, B, M);
  const VectorXd least = least_deviations(lambda, B, M, s);
  VectorXd squares = VectorXd::Zero(4), sums = VectorXd::Zero(4), stated = VectorXd::Zero(4);
  constexpr int draws = 200;
  for (unsigned draw = 0; draw < draws; ++draw) {
    const MatrixXcd noisy = q + s * NormalNumbers(1000 + draw).complex_matrix(6, M);
    const auto modes = sorted(dmd<Complex>(noisy, dt, 6, {DmdVariant::optimised, 2}));
    for (Index j = 0; j < 2; ++j) {
      const DmdMode& mode = modes[static_cast<std::size_t>(j)];
      const Complex error = mode.lambda - lambda(j);
      squares.segment(2 * j, 2) += VectorXd{{std::norm(error.real()), std::norm(error.imag())}};
      sums.segment(2 * j, 2) += VectorXd{{error.real(), error.imag()}};
      stated.segment(2 * j, 2) += VectorXd{{mode.growth_error, mode.omega_error}};
    }
  }
  // A root mean square of 200 draws is uncertain by a twentieth.
  for (Index k = 0; k < 4; ++k) {
    EXPECT_NEAR(std::sqrt(squares(k) / draws) / least(k), 1, 0.15) << k;
    EXPECT_NEAR(stated(k) / draws / least(k), 1, 0.1) << k;
    EXPECT_LT(std::abs(sums(k) / draws), 4 * least(k) / std::sqrt(draws)) << "no bias, " << k;
  }
}

// How often errors are within the stated deviation: 68 of a hundred times.
double share_within_errors(DmdVariant variant, Complex lambda, double s) {
  const MatrixXcd B = NormalNumbers(4).complex_matrix(20, 1);
  const MatrixXd q = exponentials(VectorXcd::Constant(1, lambda), B, 200).real();
  constexpr int draws = 150;
  int within = 0;
  for (unsigned draw = 0; draw < draws; ++draw) {
    const MatrixXd noisy = q + s * NormalNumbers(2000 + draw).matrix(20, 200);
    const DmdMode mode = sorted(dmd<double>(noisy, dt, 20, {variant, 2})).back();
    within += std::abs(mode.lambda.real() - lambda.real()) < mode.growth_error ? 1 : 0;
    within += std::abs(mode.lambda.imag() - lambda.imag()) < mode.omega_error ? 1 : 0;
  }
  return within / (2.0 * draws);
}

TEST(OptimisedDmd, StatesItsErrorInRealData) {
  EXPECT_NEAR(share_within_errors(DmdVariant::optimised, {-0.02, 3}, 0.05), 0.68, 0.1);
}

TEST(ExactDmd, StatesItsErrorWhereItsBiasIsSmall) {
  EXPECT_NEAR(share_within_errors(DmdVariant::exact, {-0.02, 3}, 0.002), 0.68, 0.1);
}

TEST(Dmd, TakesTheRankOfTheSignal) {
  const KnownSum known;
  const MatrixXcd q =
      exponentials(known.lambda, known.B, 100) + 0.01 * NormalNumbers(5).complex_matrix(12, 100);
  for (const DmdVariant variant : {DmdVariant::exact, DmdVariant::optimised})
    EXPECT_EQ(dmd<Complex>(q, dt, 12, {variant, {}}).rank, 3);
}

TEST(Dmd, RefusesARankAboveThatOfTheData) {
  const KnownSum known;
  const MatrixXcd q = exponentials(known.lambda, known.B, 40);
  EXPECT_THAT(failure_of<InputError>([&] {
                dmd<Complex>(q, dt, 12, {DmdVariant::exact, 5});
              }),
              testing::HasSubstr("decompose.rank = 5 is above 3, the rank of these data"));
}

TEST(Dmd, SaysWhichEigenvaluesVanish) {
  MatrixXd q = MatrixXd::Zero(3, 6);
  for (Index m = 0; m < 6; ++m) q(0, m) = std::exp(-0.1 * static_cast<double>(m));
  q(1, 0) = 1;  // gone after one step
  const Dmd found = dmd<double>(q, 1, 3, {DmdVariant::exact, {}});
  EXPECT_EQ(found.rank, 2);
  EXPECT_EQ(found.vanished, 1);
  EXPECT_NEAR(found.modes.front().lambda.real(), -0.1, 1e-12);
}

// One shape for both phases: no rank above one, so that one real exponential is all that exact
// modes of single snapshots can have, and it is wrong.
TEST(Dmd, TellsAnOscillationThatStands) {
  const VectorXd shape = NormalNumbers(7).matrix(20, 1);
  MatrixXd q(20, 120);
  for (Index m = 0; m < 120; ++m) q.col(m) = shape * std::cos(5.5 * dt * static_cast<double>(m));
  EXPECT_GT(dmd<double>(q, dt, 20, {DmdVariant::exact}).misfit, 0.5);
  for (const DmdChoice& choice :
       {DmdChoice{DmdVariant::exact, {}, 2}, DmdChoice{DmdVariant::optimised, {}, 2},
        DmdChoice{DmdVariant::optimised, 2, 1}}) {
    const Dmd found = dmd<double>(q, dt, 20, choice);
    ASSERT_EQ(found.rank, 2);
    EXPECT_LT(std::abs(found.modes.front().lambda - Complex(0, 5.5)), 1e-9)
        << "with omega > 0 first";
    EXPECT_NEAR(found.modes.front().amplitude, shape.norm() / 2, 1e-9) << "half of the pair's";
    EXPECT_LT(found.misfit, 1e-9);
  }
}

TEST(OptimisedDmd, KeepsThePairsOfRealDataInNoise) {
  const MatrixXd q = exponentials(VectorXcd{{Complex(0.1, 4), Complex(-0.2, 9)}},
                                  NormalNumbers(8).complex_matrix(16, 2), 150)
                         .real() +
                     0.2 * NormalNumbers(9).matrix(16, 150);
  const Dmd found = dmd<double>(q, dt, 16, {DmdVariant::optimised, 4});
  ASSERT_EQ(found.modes.size(), 4U);
  for (std::size_t k = 0; k < 4; k += 2) {
    EXPECT_GT(found.modes[k].lambda.imag(), 0);
    EXPECT_EQ(found.modes[k + 1].lambda, std::conj(found.modes[k].lambda));
  }
}

// More exponentials than the data have: a sentence, and never a number that is none.
TEST(OptimisedDmd, RefusesAFitThatDoesNotConverge) {
  const MatrixXd q =
      exponentials(VectorXcd{{Complex(0.1, 4)}}, NormalNumbers(10).complex_matrix(8, 1), 200)
          .real() +
      0.3 * NormalNumbers(11).matrix(8, 200);
  for (Index rank = 2; rank <= 8; ++rank) {
    try {
      const Dmd found = dmd<double>(q, dt, 8, {DmdVariant::optimised, rank});
      double nearest = INFINITY;
      for (const DmdMode& mode : found.modes) {
        EXPECT_TRUE(std::isfinite(mode.amplitude + mode.growth_error + std::abs(mode.lambda)));
        nearest = std::min(nearest, std::abs(mode.lambda - Complex(0.1, 4)));
      }
      EXPECT_LT(nearest, 0.05) << rank;
    } catch (const SolverError& error) {
      EXPECT_GT(rank, 2);
      EXPECT_THAT(error.what(), testing::HasSubstr("decompose.rank"));
    }
  }
}

TEST(OptimisedDmd, HoldsForStrongGrowth) {
  const VectorXcd lambda{{Complex(8, 5), Complex(-1, 8)}};
  const MatrixXcd q = exponentials(lambda, NormalNumbers(6).complex_matrix(10, 2), 60);
  const auto modes = sorted(dmd<Complex>(q, dt, 10, {DmdVariant::optimised, 1}));
  EXPECT_NEAR(modes.front().lambda.real(), 8, 1e-6) << "the decaying one is lost beside e^48";
}

}  // namespace
}  // namespace pennon::decomposition

/// The flat solver against dense matrices of the same Kronecker sums, on each of its paths.
#include "dns/numerics/separable_solver.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace pennon::dns {
namespace {

using RowMatrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// Of what a residual or a transform is made of: sums of n terms by several transforms.
constexpr double roundoff = 1e3 * epsilon;

RowMatrix noise(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return RowMatrix::NullaryExpr(rows, columns, [&] { return uniform(random); });
}

// d_theta^2 - sin^2(theta) k^2/4 on theta = t - b sin t, as the pressure has it.
struct Along {
  Eigen::VectorXd S;
  Eigen::MatrixXd A;

  Along(int n, double k, double b) : S(n), A(Eigen::MatrixXd::Zero(n, n)) {
    const auto corner = [&](int i) {
      const double t = 2 * std::numbers::pi * i / n;
      return t - b * std::sin(t);
    };
    for (int i = 0; i < n; ++i) {
      S[i] = corner(i + 1) - corner(i);
      const double sine = std::sin((corner(i) + corner(i + 1)) / 2);
      const double before = 2 / (corner(i + 1) - corner(i - 1));
      const double behind = 2 / (corner(i + 2) - corner(i));
      A(i, (i + n - 1) % n) += before;
      A(i, (i + 1) % n) += behind;
      A(i, i) -= before + behind + S[i] * k * k / 4 * sine * sine;
    }
  }
  Eigen::MatrixXd T() const { return S.cwiseInverse().asDiagonal() * A; }
};

Along without_symmetry(int n) {
  Along along(n, 0, 0);
  const Eigen::MatrixXd M = noise(n, n, 17);
  along.A = -M * M.transpose();
  along.S = noise(n, 1, 18).array() + 2;
  return along;
}

Tridiagonal across(int n) {
  // Neither symmetric nor of constant coefficients.
  Tridiagonal rho{noise(n, 1, 1).cwiseAbs(), Eigen::VectorXd(n), noise(n, 1, 2).cwiseAbs()};
  rho.diagonal = -rho.lower - rho.upper - noise(n, 1, 3).cwiseAbs();
  return rho;
}

Eigen::MatrixXd dense(const Tridiagonal& rho) {
  const Eigen::Index n = rho.diagonal.size();
  Eigen::MatrixXd R = rho.diagonal.asDiagonal();
  for (Eigen::Index j = 1; j < n; ++j) {
    R(j, j - 1) = rho.lower[j];
    R(j - 1, j) = rho.upper[j - 1];
  }
  return R;
}

struct Path {
  const char* name;
  Along along;
  bool is_circulant;
};

std::vector<Path> paths() {
  return {{"Fourier", Along(20, 0, 0), true},
          {"Fourier, twice an odd number", Along(14, 0, 0), true},
          {"two folds, circulant", Along(20, 0, 0), false},
          {"two folds", Along(24, 2.5, 0), false},
          {"one fold, twice an odd number", Along(14, 2.5, 0), false},
          {"one fold, clustered", Along(24, 2.5, 0.6), false},
          {"no fold", without_symmetry(12), false},
          {"no fold, an odd number", without_symmetry(7), false}};
}

TEST(SeparableSolver, SolvesWhatADenseMatrixOfTheKroneckerSumSolves) {
  constexpr int n_rho = 13;
  const Tridiagonal rho = across(n_rho);
  for (const Path& path : paths()) {
    const Eigen::Index n = path.along.S.size();
    SeparableSolver solver(rho, ThetaBasis(path.along.S, path.along.A, path.is_circulant));
    const RowMatrix f = noise(n_rho, n, 5);
    RowMatrix p = f;
    solver.solve(p.data());
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(n_rho * n, n_rho * n);
    const Eigen::MatrixXd R = dense(rho), T = path.along.T();
    for (Eigen::Index j = 0; j < n_rho; ++j) {
      sum.block(j * n, j * n, n, n) = T;
      for (Eigen::Index l = 0; l < n_rho; ++l)
        sum.block(j * n, l * n, n, n) += R(j, l) * Eigen::MatrixXd::Identity(n, n);
    }
    const Eigen::Map<const Eigen::VectorXd> right(f.data(), f.size()), found(p.data(), p.size());
    const Eigen::PartialPivLU<Eigen::MatrixXd> factors(sum);
    const Eigen::VectorXd expected = factors.solve(right);
    EXPECT_LT((found - expected).norm(), roundoff / factors.rcond() * expected.norm()) << path.name;
    EXPECT_LT((sum * found - right).norm(), roundoff * sum.norm() * found.norm()) << path.name;
  }
}

TEST(SeparableSolver, GivesTheSameTwiceAndFromOddAddresses) {
  const Along along(20, 0, 0);
  SeparableSolver solver(across(9), ThetaBasis(along.S, along.A, true));
  const RowMatrix f = noise(9, 20, 5);
  RowMatrix first = f, second = f;
  solver.solve(first.data());
  solver.solve(second.data());
  EXPECT_EQ(first, second);
  std::vector<double> shifted(static_cast<std::size_t>(f.size()) + 1);
  std::copy_n(f.data(), f.size(), shifted.data() + 1);
  solver.solve(shifted.data() + 1);
  const Eigen::Map<const RowMatrix> odd(shifted.data() + 1, 9, 20);
  EXPECT_LT((odd - first).norm(), roundoff * first.norm());
}

TEST(ThetaBasis, TakesRowsToCoefficientsAndBack) {
  constexpr int rows = 3;
  for (const Path& path : paths()) {
    ThetaBasis basis(path.along.S, path.along.A, path.is_circulant);
    const RowMatrix f = noise(rows, path.along.S.size(), 5);
    RowMatrix values = f, coefficients(rows, basis.eigenvalues().size());
    basis.to_coefficients(values.data(), coefficients.data(), rows);
    basis.to_values(coefficients.data(), values.data(), rows);
    EXPECT_LT((values - f).norm(), roundoff * f.norm()) << path.name;
  }
}

TEST(ThetaBasis, MultipliesCoefficientsByEigenvaluesWhereTheOperatorIsApplied) {
  constexpr int rows = 3;
  for (const Path& path : paths()) {
    ThetaBasis basis(path.along.S, path.along.A, path.is_circulant);
    const Eigen::Index n = basis.eigenvalues().size();
    const auto coefficients = [&](RowMatrix values) {
      RowMatrix result(rows, n);
      basis.to_coefficients(values.data(), result.data(), rows);
      return result;
    };
    const RowMatrix f = noise(rows, path.along.S.size(), 5);
    const RowMatrix of_f = coefficients(f);
    const RowMatrix of_Tf = coefficients(f * path.along.T().transpose());
    EXPECT_LT((of_Tf - of_f * basis.eigenvalues().asDiagonal()).norm(), roundoff * of_Tf.norm())
        << path.name;
  }
}

TEST(ThetaBasis, HasTheKnownEigenvaluesOfTheSecondDifference) {
  constexpr int n = 20;
  const double h = 2 * std::numbers::pi / n;
  const Along along(n, 0, 0);
  const ThetaBasis fourier(along.S, along.A, true), folded(along.S, along.A, false);
  std::vector<double> expected, found(folded.eigenvalues().begin(), folded.eigenvalues().end());
  for (int m = 0; m < n; ++m) expected.push_back(-std::pow(2 / h * std::sin(m * h / 2), 2));
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  const double largest = 4 / (h * h);
  for (std::size_t m = 0; m < n; ++m) EXPECT_NEAR(found[m], expected[m], roundoff * largest) << m;
  for (Eigen::Index m = 0; m <= n / 2; ++m)
    EXPECT_NEAR(fourier.eigenvalues()[2 * m],
                -std::pow(2 / h * std::sin(static_cast<double>(m) * h / 2), 2), roundoff * largest)
        << m;
}

}  // namespace
}  // namespace pennon::dns

/// Pairs of modes and adjoints of a dense pencil whose eigenvectors are known.
#include "modes/global/solve/spectrum.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <limits>
#include <random>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;

constexpr int n = 6;
constexpr double gap = 1e-3;  // of the nearly repeated pair
constexpr double epsilon = std::numeric_limits<double>::epsilon();

MatrixXcd noise(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  return MatrixXcd::NullaryExpr(n, n, [&] { return Complex(number(random), number(random)); });
}

// With the modes Q and a positive definite B, A = B Q Lambda Q^-1 has the adjoints P = (B Q)^-H:
// then P^H A = Lambda P^H B and P^H B Q = 1.
struct Known {
  VectorXcd lambda{n};
  MatrixXcd Q = noise(1) + 2 * MatrixXcd::Identity(n, n), B, P;

  Known() {
    lambda << Complex(0.5, 2), Complex(0.5, 2 + gap), Complex(-0.3, 0), Complex(-1, 4),
        Complex(0.1, -3), Complex(-2, 1);
    const MatrixXcd factor = 0.3 * noise(2) + MatrixXcd::Identity(n, n);
    B = factor * factor.adjoint();
    for (int k = 0; k < n; ++k) Q.col(k) /= std::sqrt(Q.col(k).dot(B * Q.col(k)).real());
    P = (B * Q).adjoint().inverse();
  }
  SparsePencil pencil() const {
    return {MatrixXcd(B * Q * lambda.asDiagonal() * Q.inverse()).sparseView(), B.sparseView()};
  }
  // The pairs, with modes and adjoints that hold shares of up to `error` of the others, and
  // eigenvalues that are as wrong.
  std::vector<Eigenpair> pairs(double error) const {
    const MatrixXcd wrong_Q = Q * (MatrixXcd::Identity(n, n) + error * noise(3));
    const MatrixXcd wrong_P = P * (MatrixXcd::Identity(n, n) + error * noise(4));
    const VectorXcd wrong = error * noise(5).diagonal();
    std::vector<Eigenpair> pairs;
    for (int k = 0; k < n; ++k) {
      Eigenpair& pair = pairs.emplace_back();
      pair.lambda = lambda[k] + wrong[k];
      pair.q = wrong_Q.col(k);
      pair.p = wrong_P.col(k);
      normalise(pencil(), pair);
    }
    return pairs;
  }
  // The largest difference from the known eigenvalues.
  double eigenvalue_error(const std::vector<Eigenpair>& pairs) const {
    double largest = 0;
    for (int k = 0; k < n; ++k)
      largest = std::max(largest, std::abs(pairs[static_cast<std::size_t>(k)].lambda - lambda[k]));
    return largest;
  }
  // The largest share of another mode in a mode, or of another adjoint in an adjoint.
  double share_of_others(const std::vector<Eigenpair>& pairs) const {
    double largest = 0;
    for (int k = 0; k < n; ++k) {
      const Eigenpair& pair = pairs[static_cast<std::size_t>(k)];
      VectorXcd modes = P.adjoint() * B * pair.q, adjoints = (B * Q).adjoint() * pair.p;
      for (VectorXcd* shares : {&modes, &adjoints}) {
        *shares /= (*shares)[k];
        (*shares)[k] = 0;
        largest = std::max(largest, shares->cwiseAbs().maxCoeff());
      }
    }
    return largest;
  }
};

TEST(Spectrum, BiorthogonalisesPairsToSecondOrderOfTheirErrors) {
  const Known known;
  const SparsePencil pencil = known.pencil();
  for (const double error : {1e-5, 1e-7}) {
    std::vector<Eigenpair> pairs = known.pairs(error);
    ASSERT_GT(known.share_of_others(pairs), 0.5 * error);
    ASSERT_GT(biorthogonality_defect(pencil, pairs), 0.5 * error);
    biorthogonalise(pencil, pairs);
    // What is left is of errors times errors, a dozen of them, over the gaps between eigenvalues.
    EXPECT_LT(known.share_of_others(pairs), 100 * error * error / gap) << error;
    EXPECT_LT(known.eigenvalue_error(pairs), 100 * error * error) << error;
    EXPECT_LT(biorthogonality_defect(pencil, pairs), 100 * epsilon);
    for (const Eigenpair& pair : pairs) {
      EXPECT_LT(std::abs(pair.p.dot(known.B * pair.q) - 1.0), 100 * epsilon);
      EXPECT_NEAR(pair.q.dot(known.B * pair.q).real(), 1, 100 * epsilon);
      EXPECT_LT(pair.residual, 100 * error * error / gap + 100 * epsilon);
      EXPECT_LT(pair.adjoint_residual, 100 * error * error / gap + 100 * epsilon);
    }
  }
}

// Exact pairs stay as they are but for rounding, which the gap of the nearly repeated pair
// magnifies.
TEST(Spectrum, LeavesExactPairsAsTheyAre) {
  const Known known;
  std::vector<Eigenpair> pairs = known.pairs(0);
  biorthogonalise(known.pencil(), pairs);
  EXPECT_LT(known.share_of_others(pairs), 100 * epsilon / gap);
  EXPECT_LT(known.eigenvalue_error(pairs), 100 * epsilon);
}

TEST(Spectrum, LeavesPairsAloneWhereOneHasNoAdjoint) {
  const Known known;
  std::vector<Eigenpair> pairs = known.pairs(1e-5);
  pairs[3].p.resize(0);
  const std::vector<Eigenpair> before = pairs;
  biorthogonalise(known.pencil(), pairs);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_EQ(pairs[k].lambda, before[k].lambda);
    EXPECT_EQ(pairs[k].q, before[k].q);
  }
}

}  // namespace
}  // namespace pennon::modes::global

/// Anderson's acceleration: on linear problems it is GMRES.
#include "dns/numerics/anderson.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace pennon::dns {
namespace {

// x <- x + f(x), f(x) = b - A x.
struct Linear {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;

  // Eigenvalues of 1 - A lie between -radius and radius.
  Linear(Eigen::Index n, double radius, unsigned seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    const Eigen::MatrixXd noise =
        Eigen::MatrixXd::NullaryExpr(n, n, [&] { return normal(random); });
    const Eigen::MatrixXd turn = noise.householderQr().householderQ();
    const Eigen::VectorXd spectrum = Eigen::VectorXd::LinSpaced(n, -radius, radius);
    A = Eigen::MatrixXd::Identity(n, n) - turn * spectrum.asDiagonal() * turn.transpose();
    b = Eigen::VectorXd::NullaryExpr(n, [&] { return normal(random); });
  }
  Eigen::VectorXd f(const Eigen::VectorXd& x) const { return b - A * x; }
};

double residual_after(const Linear& problem, int depth, int advances) {
  Anderson acceleration(problem.b.size(), depth);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(problem.b.size());
  for (int k = 0; k < advances; ++k) acceleration.advance(x, problem.f(x));
  return problem.f(x).norm() / problem.b.norm();
}

// The normal equations square the condition of the differences: rounding grows to its square root.
constexpr double normal_roundoff = 1e-8;

TEST(Anderson, SolvesALinearProblemInOneStepMoreThanItHasUnknowns) {
  for (const int n : {1, 2, 5, 8}) {
    const Linear problem(n, 0.9, 7);
    EXPECT_LT(residual_after(problem, n, n + 1), normal_roundoff) << n;
    EXPECT_GT(residual_after(problem, n, n), 1e-3 * normal_roundoff) << n;
  }
}

TEST(Anderson, SolvesALinearProblemWhoseIterationDiverges) {
  const Linear problem(6, 3.1, 11);
  EXPECT_LT(residual_after(problem, 6, 7), normal_roundoff);
}

TEST(Anderson, IsFasterThanTheIterationWithAShortMemory) {
  const Linear problem(40, 0.95, 3);
  EXPECT_LT(residual_after(problem, 5, 40), 0.1 * std::pow(0.95, 40));
}

TEST(Anderson, StartsWithThePlainStepAndAgainAfterARestart) {
  const Linear problem(5, 0.9, 5);
  Anderson used(5, 3), fresh(5, 3);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(5);
  for (int k = 0; k < 4; ++k) used.advance(x, problem.f(x));
  used.restart();
  Eigen::VectorXd other = x;
  const Eigen::VectorXd plain = x + problem.f(x);
  used.advance(x, problem.f(x));
  EXPECT_EQ(x, plain);
  fresh.advance(other, problem.f(other));
  for (int k = 0; k < 6; ++k) {
    used.advance(x, problem.f(x));
    fresh.advance(other, problem.f(other));
    EXPECT_EQ(x, other) << k;
  }
}

TEST(Anderson, StaysAtTheSolution) {
  Anderson acceleration(4, 3);
  const Eigen::VectorXd solution = Eigen::VectorXd::LinSpaced(4, -1, 2);
  Eigen::VectorXd x = solution;
  for (int k = 0; k < 6; ++k) {
    acceleration.advance(x, Eigen::VectorXd::Zero(4));
    EXPECT_EQ(x, solution) << k;
  }
}

}  // namespace
}  // namespace pennon::dns

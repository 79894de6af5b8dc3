/// The eigensolver on problems of known spectrum.
#include "modes/normal/generalised_eigenproblem.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

// 1e-16, ten times over.
constexpr double roundoff = 1e-15;

ExtendedSparse diagonal(Eigen::Index size, Extended value) {
  ExtendedSparse matrix(size, size);
  matrix.setIdentity();
  return matrix * value;
}

// A chain of `size` masses between two walls (free at the right end if `is_free`), as stretches and
// positions: rows 0 to size are stretches, the rest positions.
GeneralisedEigenproblem chain(Eigen::Index size, bool is_free) {
  std::vector<Eigen::Triplet<Extended>> E, S, R;
  const Eigen::Index springs = size + (is_free ? 0 : 1);
  for (Eigen::Index i = 0; i < springs; ++i) {
    if (i < size) E.emplace_back(i, i, 1);
    if (i > 0) E.emplace_back(i, i - 1, -1);
    S.emplace_back(i, i, 1);
  }
  for (Eigen::Index i = 0; i < size; ++i) {
    E.emplace_back(springs + i, i, 1);
    R.emplace_back(springs + i, springs + i, 1);
  }
  const auto sparse = [&](Eigen::Index columns, const auto& entries) {
    ExtendedSparse matrix(springs + size, columns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    return matrix;
  };
  return {sparse(size, E), sparse(springs + size, S), sparse(springs + size, R)};
}

TEST(LowestEigenpairs, OfAChainBetweenWallsAreKnown) {
  constexpr int size = 60;
  constexpr int count = 12;
  const Eigenpairs pairs = lowest_eigenpairs(chain(size, false), count, 1e-3, "chain");
  for (int m = 1; m <= count; ++m) {
    const double sine = std::sin(m * std::numbers::pi / (2 * (size + 1)));
    EXPECT_NEAR(static_cast<double>(pairs.lambda[m - 1]) / (4 * sine * sine), 1, roundoff);
  }
  EXPECT_LT(pairs.worst_residual, largest_residual);
}

TEST(LowestEigenpairs, AreNormalisedOrthogonalAndPositiveAtTheEnd) {
  const GeneralisedEigenproblem problem = chain(60, true);
  const Eigenpairs pairs = lowest_eigenpairs(problem, 10, 1e-3, "chain");
  const ExtendedMatrix at_points = problem.E * pairs.vectors;
  const ExtendedMatrix products = at_points.transpose() * (problem.R * at_points);
  EXPECT_LT(static_cast<double>((products - ExtendedMatrix::Identity(10, 10)).norm()), roundoff);
  for (int i = 0; i < 10; ++i) EXPECT_GT(pairs.vectors(59, i), 0);
}

TEST(LowestEigenpairs, HoldAMotionWithoutEnergy) {
  // Springs between neighbours only: the chain as a whole is free.
  GeneralisedEigenproblem problem = chain(40, true);
  problem.S.coeffRef(0, 0) = 0;
  const Eigenpairs pairs = lowest_eigenpairs(problem, 3, 1e-2, "free chain");
  EXPECT_NEAR(static_cast<double>(pairs.lambda[0]), 0, 1e-18);
  const double sine = std::sin(std::numbers::pi / 80);
  EXPECT_NEAR(static_cast<double>(pairs.lambda[1]) / (4 * sine * sine), 1, roundoff);
}

TEST(LowestEigenpairs, AreTheSameBitsEachTime) {
  const Eigenpairs first = lowest_eigenpairs(chain(50, false), 8, 1e-3, "chain");
  const Eigenpairs second = lowest_eigenpairs(chain(50, false), 8, 1e-3, "chain");
  EXPECT_EQ(first.lambda, second.lambda);
  EXPECT_EQ(first.vectors, second.vectors);
}

TEST(LowestEigenpairs, OfAnIndefiniteProblemAreRefused) {
  GeneralisedEigenproblem problem{diagonal(10, 1), diagonal(10, -1), diagonal(10, 1)};
  try {
    lowest_eigenpairs(problem, 2, 0.5, "negative springs");
    FAIL();
  } catch (const SolverError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("negative springs")) << error.what();
  }
}

}  // namespace
}  // namespace pennon::modes

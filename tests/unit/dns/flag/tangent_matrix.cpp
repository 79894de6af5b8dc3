/// The matrix of Newton's method: what it solves, whichever factors serve.
#include <gtest/gtest.h>

#include <cmath>

#include "dns/flag/flag.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

constexpr double roundoff = 1e-9;  // relative, with the condition of these matrices

const FlagMesh mesh(uniform_chord(9), 7, 1.3, {Edge::clamped, Edge::free, Edge::free, Edge::free});

// The tangent of a step from `start` to `end`, filled but not factored.
std::unique_ptr<TangentMatrix<3>> tangent_of(const Flag<3>& flag, const NodeVectors<3>& start,
                                             const NodeVectors<3>& end, double mass_factor) {
  auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({start, end, Pairing::discrete_gradient}, {}, mass_factor, *tangent);
  return tangent;
}

// How far the solution of a random force is from solving the matrix that was filled, relative to
// the force, both in the norm of the inverse of `scale`.
double error_of_solution(TangentMatrix<3>& tangent, const Flag<3>& flag,
                         const Eigen::MatrixXd& scale) {
  const auto packed = [&](const NodeVectors<3>& vectors) {
    Eigen::VectorXd unknowns(scale.rows());
    for (std::size_t n = 0; n < tangent.free_nodes().size(); ++n)
      unknowns.segment<3>(static_cast<Eigen::Index>(3 * n)) = vectors.col(tangent.free_nodes()[n]);
    return unknowns;
  };
  const NodeVectors<3> force = noise(flag, 1, 5);
  NodeVectors<3> solution = force;
  tangent.solve(solution);
  const Eigen::VectorXd residual = packed(force) - tangent.matrix() * packed(solution);
  const Eigen::LDLT<Eigen::MatrixXd> inverse(scale);
  return std::sqrt(residual.dot(inverse.solve(residual)) /
                   packed(force).dot(inverse.solve(packed(force))));
}

Eigen::MatrixXd symmetric_part(const TangentMatrix<3>& tangent) {
  const Eigen::MatrixXd all = tangent.matrix();
  return (all + all.transpose()) / 2;
}

TEST(TangentMatrix, IsSolvedAtOnceWhereItIsSymmetricAndDefinite) {
  const Flag<3> flag(mesh, {1, 0.01, 100, 0.3, 0});
  const auto tangent = tangent_of(flag, flag.rest(), flag.rest(), 1);
  ASSERT_TRUE(tangent->factor_if_definite());
  EXPECT_LT(error_of_solution(*tangent, flag, symmetric_part(*tangent)), roundoff);
}

TEST(TangentMatrix, IsSolvedByIterationWhereItIsNotSymmetric) {
  const Flag<3> flag(mesh, {1, 0.01, 100, 0.3, 0});
  const NodeVectors<3> start = flag.rest();
  for (const double change : {1e-4, 1e-3, 1e-2}) {
    const auto tangent = tangent_of(flag, start, start + noise(flag, change, 2), 1e3);
    ASSERT_TRUE(tangent->factor_if_definite()) << change;
    const double error = error_of_solution(*tangent, flag, symmetric_part(*tangent));
    EXPECT_GT(error, 0) << change << ": the matrix is symmetric, and no iteration is needed";
    EXPECT_LT(error, TangentMatrix<3>::solution_error) << change;
  }
}

// A compressed plate without mass: its straight shape has lost its stability.
TEST(TangentMatrix, IsSolvedWhereItIsNotDefinite) {
  const Flag<3> flag(mesh, {1, 0.01, 100, 0.3, 0});
  NodeVectors<3> x = flag.rest();
  x.row(1) *= 0.9;
  const auto tangent = tangent_of(flag, x, x, 0);
  EXPECT_FALSE(tangent->factor_if_definite());
  ASSERT_TRUE(tangent->factor());
  const Eigen::Index unknowns = tangent->matrix().rows();
  EXPECT_LT(error_of_solution(*tangent, flag, Eigen::MatrixXd::Identity(unknowns, unknowns)),
            roundoff);
}

// So far from symmetric that the iterations would be many: 1 on the diagonal, 1000, 2000, 3000 and
// their negatives off it.
TEST(TangentMatrix, IsSolvedHoweverFarFromSymmetric) {
  TangentMatrix<3> tangent(HeldNodes({false, false}), {{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  tangent.set_zero();
  const Eigen::Matrix3d skew = Eigen::Vector3d(1e3, 2e3, 3e3).asDiagonal();
  for (const int node : {0, 1}) tangent.add(node, node, Eigen::Matrix3d::Identity());
  tangent.add(0, 1, skew);
  tangent.add(1, 0, -skew);
  ASSERT_TRUE(tangent.factor_if_definite());
  NodeVectors<3> x(3, 2);
  x << 1, 2, 3, 4, 5, 6;
  const NodeVectors<3> force = x;
  tangent.solve(x);
  EXPECT_LT((x.col(0) + skew * x.col(1) - force.col(0)).norm(), roundoff * force.norm());
  EXPECT_LT((x.col(1) - skew * x.col(0) - force.col(1)).norm(), roundoff * force.norm());
}

template <int dim>
void expect_definite_below_the_critical_load(const Flag<dim>& column, double critical) {
  const NodeVectors<dim> rest = column.rest();
  for (const double share : {0.9, 1.1}) {
    NodeVectors<dim> x = rest;
    x.row(dim - 2) *= 1 - share * critical / column.material().K_S;
    const auto tangent = column.tangent_matrix();
    tangent->set_zero();
    column.add_tangent({x, x}, {}, 0, *tangent);
    EXPECT_EQ(tangent->factor_if_definite(), share < 1) << share;
  }
}

TEST(TangentMatrix, IsDefiniteBelowTheLoadOfEulerOnly) {
  // A clamped column: pi^2/4 K_B.
  const double euler = 9.8696 / 4;
  expect_definite_below_the_critical_load<2>(
      {FlagMesh(uniform_chord(61), {Edge::clamped, Edge::free}), {1, 1, 1e5, 0, 0}}, euler);
  expect_definite_below_the_critical_load<3>(
      {FlagMesh(uniform_chord(61), 3, 0.1, {Edge::clamped, Edge::free}), {1, 1, 1e5, 0, 0}}, euler);
}

}  // namespace
}  // namespace pennon::dns

#include "dns/coupling/added_mass.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dns/coupling/coupling.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using std::numbers::pi;

const OGrid& grid() {
  static const OGrid the_grid({.n_rho = 40, .n_theta = 80, .R = 8, .wall_spacing = 0.018});
  return the_grid;
}

// Of the plate that accelerates as a whole, per span.
double of_plunging(double k) {
  const std::vector<double> chord = coupled_chord(grid());
  const auto segments = static_cast<Eigen::Index>(chord.size()) - 1;
  Eigen::VectorXd lengths(segments);
  for (Eigen::Index s = 0; s < segments; ++s)
    lengths[s] = chord[static_cast<std::size_t>(s) + 1] - chord[static_cast<std::size_t>(s)];
  return lengths.dot(flat_jump_response(grid(), k) * lengths);
}

TEST(FlatJumpResponse, OfAPlungingPlateIsAQuarterOfPi) {
  EXPECT_NEAR(of_plunging(0) / (pi / 4), 1, 0.005);
}

// On a plate far longer than the wave along its span, a sheet wetted on both sides: 2/k per area
// (Lamb), less at the edges; the strip of a chord carries 2/k - 2/k^2 (lsa/ has it by Wiener &
// Hopf).
TEST(FlatJumpResponse, OfShortWavesAlongTheSpanIsThatOfASheetLessItsEdges) {
  for (const double k : {10.0, 20.0})
    EXPECT_NEAR(of_plunging(k) / (2 / k - 2 / (k * k)), 1, 0.01) << k;
}

// Energy is quadratic in the acceleration: the response is symmetric and positive, but for the
// extrapolation of the pressure to the wall.
TEST(FlatJumpResponse, IsSymmetricButForTheExtrapolationAndPositive) {
  const Eigen::MatrixXd response = flat_jump_response(grid(), 2);
  EXPECT_LT((response - response.transpose()).norm(), 0.02 * response.norm());
  const Eigen::MatrixXd symmetric = (response + response.transpose()) / 2;
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(symmetric).eigenvalues().minCoeff(), 0);
}

template <int dim>
FlagMesh mesh() {
  const EdgeConditions edges{.leading = Edge::clamped};
  if constexpr (dim == 2) return {coupled_chord(grid()), edges};
  return {coupled_chord(grid()), 6, 1.5, edges};
}

// The area vectors of the segments of a flag at x, mid-surface.
template <int dim>
NodeVectors<dim> areas_of(const FlagMesh& mesh, const NodeVectors<dim>& x) {
  const int segments = mesh.chord_nodes() - 1;
  NodeVectors<dim> areas = NodeVectors<dim>::Zero(dim, mesh.stations() * segments);
  for (int m = 0; m < mesh.stations(); ++m)
    for (int s = 0; s < segments; ++s) {
      const Eigen::Matrix<double, dim, 1> along =
          x.col(mesh.index(m, s + 1)) - x.col(mesh.index(m, s));
      areas(dim - 2, m * segments + s) = -along[dim - 1];
      areas(dim - 1, m * segments + s) = along[dim - 2];
    }
  return areas;
}

template <int dim>
void expect_solved() {
  const FlagMesh the_mesh = mesh<dim>();
  const Flag<dim> flag(the_mesh, {.mu = 0.02, .K_B = 1e-3, .K_S = 100});
  NodeVectors<dim> x = flag.rest();
  for (int node = 0; node < the_mesh.nodes(); ++node)
    x(dim - 1, node) = 0.2 * std::pow(x(dim - 2, node), 2) * (dim == 3 ? 1 + 0.3 * x(0, node) : 1);
  AddedMass<dim> added_mass(grid(), the_mesh, flag.material().mu);
  added_mass.set_areas(areas_of(the_mesh, x));
  constexpr double mass_factor = 2e5;
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({x, x}, {}, mass_factor, *tangent);
  ASSERT_TRUE(tangent->factor());
  const NodeVectors<dim> r = test::at_free_nodes(flag, test::noise(flag, 1, 7));
  // r - (K + mass_factor M_a) x, by K's own matrix.
  const auto residual_of = [&](const NodeVectors<dim>& guess) {
    NodeVectors<dim> residual = r;
    added_mass.subtract_force(mass_factor * guess, residual);
    const auto& free = tangent->free_nodes();
    Eigen::VectorXd unknowns(dim * static_cast<Eigen::Index>(free.size()));
    for (std::size_t n = 0; n < free.size(); ++n)
      unknowns.segment<dim>(static_cast<Eigen::Index>(dim * n)) = guess.col(free[n]);
    const Eigen::VectorXd product = tangent->matrix() * unknowns;
    for (std::size_t n = 0; n < free.size(); ++n)
      residual.col(free[n]) -= product.segment<dim>(static_cast<Eigen::Index>(dim * n));
    return test::at_free_nodes(flag, residual);
  };
  NodeVectors<dim> solution = r;
  added_mass.solve(*tangent, mass_factor, solution);
  // What it lacks is small, and its own solution makes up for it.
  NodeVectors<dim> lacking = residual_of(solution);
  added_mass.solve(*tangent, mass_factor, lacking);
  EXPECT_LT(lacking.norm(), 0.03 * solution.norm());
  for (int turn = 0; turn < 2; ++turn) {
    solution += lacking;
    lacking = residual_of(solution);
    added_mass.solve(*tangent, mass_factor, lacking);
  }
  EXPECT_LT(lacking.norm(), 1e-5 * solution.norm());
  // Without the added mass the residual is of the order of r itself: the test can tell.
  NodeVectors<dim> alone = r;
  tangent->solve(alone);
  EXPECT_GT((alone - solution).norm(), 0.1 * solution.norm());
}

TEST(AddedMassOfAFlag, IsSolvedForWithTheTangent) {
  expect_solved<2>();
  expect_solved<3>();
}

}  // namespace
}  // namespace pennon::dns

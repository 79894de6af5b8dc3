// In a fluid at rest the modes of flag and fluid are those of a plate with the added mass of
// potential flow, slower by what the Stokes layer adds.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "common/petsc/petsc.hpp"
#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/slepc/krylov_schur.hpp"
#include "modes/global/solve/slepc/mumps_factors.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr dns::FlagMaterial plate{.mu = 0.1, .K_B = 0.25};

// Frequencies of the clamped plate by Ritz's method with the polynomials y^(k + 2). A plate's
// velocity w(y) gives w sin theta = sum c_n sin n theta on y = (1 + cos theta)/2, the potential of
// the fluid above it -1/2 sum c_n/n exp(-n rho) sin n theta, and the added mass pi/4 sum c_n^2/n
// (pi/4 where it moves broadside).
std::array<double, 2> frequencies_in_potential_flow() {
  constexpr int shapes = 8, terms = 40, points = 400;
  Eigen::MatrixXd mass(shapes, shapes), stiffness(shapes, shapes),
      c = Eigen::MatrixXd::Zero(shapes, terms);
  for (int k = 0; k < shapes; ++k)
    for (int m = 0; m < points; ++m) {
      const double theta = (m + 0.5) * std::numbers::pi / points;
      const double w = std::pow((1 + std::cos(theta)) / 2, k + 2);
      for (int n = 1; n <= terms; ++n)
        c(k, n - 1) += 2.0 / points * w * std::sin(theta) * std::sin(n * theta);
    }
  for (int k = 0; k < shapes; ++k)
    for (int l = 0; l < shapes; ++l) {
      const double curvatures = (k + 2) * (k + 1) * (l + 2) * (l + 1);
      stiffness(k, l) = plate.K_B * curvatures / (k + l + 1);
      mass(k, l) = plate.mu / (k + l + 5);
      for (int n = 1; n <= terms; ++n)
        mass(k, l) += std::numbers::pi / 4 * c(k, n - 1) * c(l, n - 1) / n;
    }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(stiffness, mass);
  return {std::sqrt(solver.eigenvalues()[0]), std::sqrt(solver.eigenvalues()[1])};
}

Complex mode_in_still_fluid(double Re, double omega) {
  const dns::OGrid grid({.n_rho = 32, .n_theta = 64, .R = 8, .wall_spacing = 0.02});
  const Extent extent{1, grid.n_rho(), grid.n_theta()};
  const std::vector<double> none(static_cast<std::size_t>(grid.n_theta() / 2), 0.0);
  const BaseFlow at_rest{{.Re = Re, .dt_of_pressure = 1e-3},
                         PlaneFlow<double>(extent, 2),
                         std::vector<bool>(extent.wall_faces(), false),
                         {none, none, none},
                         std::vector<double>(none.size() + 1, 0.0)};
  const FlagOperator flag =
      flag_operator(dns::coupled_chord(grid), dns::Edge::clamped, plate, at_rest.forces, 0, 1);
  const CoupledOperator coupled = coupled_operator(grid, at_rest, flag, 0);
  const Spectrum spectrum =
      coupled_eigenpairs_near(coupled, {-0.05 * omega, 0.95 * omega}, 1, false, mumps_factors());
  return spectrum.pairs.at(0).lambda;
}

TEST(GlobalModesInStillFluid, AreThoseOfThePlateWithItsAddedMassUpToTheStokesLayer) {
  petsc::start();
  const SlepcSession session;
  for (const double omega : frequencies_in_potential_flow()) {
    std::vector<double> slowing, damping;  // over the frequency
    for (const double Re : {400.0, 1600.0, 6400.0}) {
      const Complex lambda = mode_in_still_fluid(Re, omega);
      slowing.push_back(1 - lambda.imag() / omega);
      damping.push_back(-lambda.real() / omega);
    }
    // The layer is (2/(Re omega))^1/2 thick: half as thick for four times Re. At the edges, where
    // the potential flow is faster without bound, its effect falls a little more slowly.
    for (std::size_t k = 1; k < slowing.size(); ++k) {
      EXPECT_GT(slowing[k - 1] / slowing[k], 1.6);
      EXPECT_LT(slowing[k - 1] / slowing[k], 2.1);
      EXPECT_GT(damping[k - 1] / damping[k], 1.6);
      EXPECT_LT(damping[k - 1] / damping[k], 2.1);
      // It resists as much as it weighs, but for terms of second order and the grid's.
      EXPECT_NEAR(damping[k] / slowing[k], 0.8, 0.05);
    }
    constexpr double of_grid_and_edges = 0.01;
    EXPECT_NEAR(2 * slowing[2] - slowing[1], 0, of_grid_and_edges);  // without friction
  }
}

}  // namespace
}  // namespace pennon::modes::global

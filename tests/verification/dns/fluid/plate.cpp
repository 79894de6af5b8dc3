// The plate at rest along the stream: the drag, its beginning, and a cross-flow along the span.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

FluidCase plate(double Re, int n_rho, double R, double U = 0) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, R, 1.2 / n_rho, 0};
  settings.parameters = {Re, U};
  return settings;
}

// Of both sides.
double drag(const FluidRun& run) {
  return 2 * run.force()[1];
}

// The boundary layers of both sides by Blasius, and with what the trailing edge adds (Jobe &
// Burggraf 1974: triple deck), which holds within 5 % down to Re = 1 by their comparison.
double blasius_drag(double Re) {
  return 2 * 1.328 / std::sqrt(Re);
}
double triple_deck_drag(double Re) {
  return blasius_drag(Re) + 2 * 2.67 * std::pow(Re, -7.0 / 8);
}

// The plate's steady drag is Blasius's and what the trailing edge adds, and settles with the grid.
TEST(Plate, HasTheDragOfBoundaryLayerTheory) {
  for (const double Re : {200.0, 1000.0}) {
    constexpr double dt = 0.04, steady = 20;  // convection is implicit
    std::array<double, 2> found{};
    for (std::size_t n = 0; n < 2; ++n) {
      FluidRun run(plate(Re, n == 0 ? 30 : 60, 8));
      run.run_to(steady, dt);
      found[n] = drag(run);
    }
    const double fine_grid = found[1] + (found[1] - found[0]) / 3;  // of second order
    for (const double C_D : {found[0], found[1], fine_grid}) {
      EXPECT_GT(C_D, blasius_drag(Re)) << Re;
      EXPECT_NEAR(C_D / triple_deck_drag(Re), 1, 0.05) << Re;
    }
    // Measured: 0.6 % at Re = 200, 1.4 % at Re = 1000.
    EXPECT_NEAR(found[0] / found[1], 1, 0.02) << Re;
    EXPECT_NEAR(fine_grid / triple_deck_drag(Re), 1, 0.01) << Re;
  }
}

// The grid of a boundary layer at Re: its first cells at a fixed share of the thickness.
FluidCase boundary_layer_plate(double Re, int n_rho, double R, double U = 0) {
  FluidCase settings = plate(Re, n_rho, R, U);
  settings.grid.wall_spacing = 24.0 / n_rho / std::sqrt(Re);
  return settings;
}

// Skin friction away from the edges over Blasius's 0.332 (Re y)^-1/2, mean of 0.3 < y < 0.6.
double relative_friction(const FluidRun& run, double Re) {
  const WallTraction traction = run.traction();
  double sum = 0;
  int count = 0;
  for (int i = 0; 2 * i < run.grid().n_theta(); ++i) {  // the upper side, from behind
    const double y = (1 + std::cos(run.grid().theta_centre(i))) / 2;
    if (y < 0.3 || y > 0.6) continue;
    sum -= traction.friction[static_cast<std::size_t>(i)] * std::sqrt(Re * y) / 0.332;
    ++count;
  }
  return sum / count;
}

// The displaced stream speeds the boundary layer up by a share that falls as Re^-1/2: 11 % at Re =
// 1000. What is left without it is Blasius's friction.
TEST(Plate, HasBlasiusFrictionAwayFromTheEdges) {
  std::array<double, 2> friction{};
  constexpr std::array<double, 2> Re = {1000, 4000};
  for (std::size_t n = 0; n < 2; ++n) {
    FluidRun run(boundary_layer_plate(Re[n], 48, 8));
    run.run_to(8, 0.02);
    friction[n] = relative_friction(run, Re[n]);
    EXPECT_GT(friction[n], 1);
  }
  EXPECT_NEAR((friction[0] - 1) / (friction[1] - 1), 2, 0.2);
  EXPECT_NEAR(2 * friction[1] - friction[0], 1, 0.01);
}

// A plate that starts at once drags as Rayleigh's infinite one, C_D = 4 (pi Re t)^-1/2, until what
// begins at its edges has spread: by diffusion over (t/Re)^1/2, from the leading edge over t.
TEST(Plate, StartsWithRayleighsDrag) {
  // Departures from Rayleigh's, by Re and time: of the drag, and of the friction at mid-chord.
  std::array<std::array<double, 2>, 2> whole{}, middle{};
  constexpr std::array<double, 2> Re = {1000, 4000}, t = {0.0125, 0.05};
  for (std::size_t n = 0; n < 2; ++n) {
    FluidCase settings = plate(Re[n], 60, 4);
    settings.grid.wall_spacing = 0.1 / std::sqrt(Re[n]);
    FluidRun run(settings);
    for (std::size_t k = 0; k < 2; ++k) {
      run.run_to(t[k], 5e-4);
      const double rayleigh = 1 / std::sqrt(pi * Re[n] * t[k]);
      const std::vector<double> friction = run.traction().friction;
      whole[n][k] = drag(run) / (4 * rayleigh) - 1;
      middle[n][k] = -(friction[29] + friction[30]) / 2 / rayleigh - 1;
    }
  }
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_GT(whole[n][k], 0);
      EXPECT_LT(whole[n][k], 0.07);
      EXPECT_NEAR(middle[n][k], 0, 0.016);
    }
  // The edges' share between (t/Re)^1/2 and t: a half to a quarter of it at a quarter of the time,
  // a half or more of it at four times Re.
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_LT(whole[n][0] / whole[n][1], 0.5);
    EXPECT_GT(whole[n][0] / whole[n][1], 0.25);
  }
  EXPECT_GT(whole[1][1] / whole[0][1], 0.5);
  EXPECT_LT(whole[1][1] / whole[0][1], 1);
  // At mid-chord only the displaced stream is felt, as thick as (t/Re)^1/2.
  EXPECT_NEAR(middle[1][1] / middle[0][1], 0.5, 0.05);
}

// Cells at the edges of the plate that are longer in rho than in theta: the pressure's extension to
// the wall, if it goes through three cells, feeds back there, and any asymmetry grows 1.07-fold in
// each step.
TEST(Plate, StaysQuietOnCellsLongerInRhoThanInTheta) {
  FluidCase settings = plate(200, 80, 6);
  settings.grid = {80, 120, 6, 0.04, 0.5};
  FluidRun run(settings);
  constexpr double dt = 0.005;
  run.run_to(0.1, dt);
  const double calm = run.last().CFL;
  run.at_cells([&](int, int j, int i) {
    const auto [y, z] = run.fluid().centre(run.state(), 0, j, i);
    run.state().u[1].row(0, j)[i] +=
        0.1 * (y - 1.5) * std::exp(-4 * ((y - 1.5) * (y - 1.5) + z * z));
  });
  run.state().u_last = run.state().u;
  run.run_to(0.6, dt);
  EXPECT_LT(run.last().CFL, 1.1 * calm);
  EXPECT_LT(std::abs(run.force()[2]), 0.01);
}

// Largest difference between two fields of a plane.
double difference(const Field<double>& a, int plane, const Field<double>& b) {
  double largest = 0;
  for (int j = 0; j < a.extent().n_rho; ++j)
    for (int i = 0; i < a.extent().n_theta; ++i)
      largest = std::max(largest, std::abs(a.row(plane, j)[i] - b.row(0, j)[i]));
  return largest;
}

// The independence principle: about a body that does not change along the span the equations of v,
// w and p do not know u.
TEST(CrossFlow, LeavesTheFlowAcrossTheSpanUnchanged) {
  const PointMotion pitch = [](double t, double, double y) -> std::array<double, 2> {
    return {0, 0.1 * y * std::sin(3 * t)};
  };
  FluidCase settings = plate(500, 24, 4);
  settings.tolerances.pressure = 1e-11;
  settings.tolerances.velocity = 1e-12;
  FluidRun alone(settings, pitch);
  settings.parameters.U = 0.8;
  FluidRun crossed(settings, pitch);
  settings.planes = 4;
  FluidRun spanned(settings, pitch);
  for (FluidRun* run : {&alone, &crossed, &spanned}) run->run_to(0.5, 0.01);
  const FluidState& reference = alone.state();
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(difference(crossed.state().u[c], 0, reference.u[c]), 0);
    // As far as the solvers are converged: they stop by the mean over the planes.
    for (int plane = 0; plane < 4; ++plane)
      EXPECT_LT(difference(spanned.state().u[c], plane, reference.u[c]), 1e-9);
  }
  EXPECT_EQ(difference(crossed.state().p, 0, reference.p), 0);
  for (int plane = 0; plane < 4; ++plane) {
    EXPECT_LT(difference(spanned.state().p, plane, reference.p), 1e-8);
    EXPECT_LT(difference(spanned.state().u[2], plane, crossed.state().u[2]), 1e-9);
  }
}

// u is carried and diffused as a passive scalar, between 0 on the flag and U far away: its equation
// is that of v without the pressure. So u is proportional to U, and where the boundary layer's
// pressure does not change u/U = v/V, Blasius's profile: the difference is the pressure's share,
// which falls as Re^-1/2. So does, nearly, what the edges add to the spanwise drag.
TEST(CrossFlow, IsAPassiveScalarThatFollowsBlasius) {
  constexpr std::array<double, 2> Re = {500, 2000};
  std::array<double, 2> profile{}, excess{};
  for (std::size_t n = 0; n < 2; ++n) {
    constexpr double U = 0.5;
    FluidRun run(boundary_layer_plate(Re[n], 48, 8, U));
    run.run_to(8, 0.02);
    const auto& u = run.state().u;
    run.at_cells([&](int, int j, int i) {
      const double u_here = u[2].row(0, j)[i] / U;
      EXPECT_GT(u_here, -0.02);  // the upwind differences overshoot a little
      EXPECT_LT(u_here, 1.05);
      const auto [y, z] = run.fluid().centre(run.state(), 0, j, i);
      if (y > 0.3 && y < 0.6 && std::abs(z) < 5 / std::sqrt(Re[n]))
        profile[n] = std::max(profile[n], std::abs(u_here - u[0].row(0, j)[i]));
    });
    const Vector3 force = run.force();
    excess[n] = 2 * force[0] / U / blasius_drag(Re[n]) - 1;
    EXPECT_LT(force[0] / U, force[1]) << "the trailing edge's pressure adds to the drag along y";
  }
  EXPECT_NEAR(profile[1] / profile[0], 0.5, 0.1);
  EXPECT_GT(excess[1], 0);
  EXPECT_LT(excess[1], 0.65 * excess[0]);
}

// Twice the cross-flow is twice u, to rounding and the solver's tolerance.
TEST(CrossFlow, IsLinear) {
  FluidCase settings = plate(500, 24, 4, 0.5);
  settings.tolerances.velocity = 1e-13;
  FluidRun single(settings);
  settings.parameters.U = 1;
  FluidRun twice(settings);
  for (FluidRun* run : {&single, &twice}) run->run_to(0.5, 0.01);
  single.at_cells([&](int, int j, int i) {
    ASSERT_NEAR(2 * single.state().u[2].row(0, j)[i], twice.state().u[2].row(0, j)[i], 1e-10);
  });
}

// A stream that rises smoothly: far from the plate it is all there is, and once it has risen the
// plate forgets how.
TEST(Plate, ForgetsHowTheStreamRose) {
  FluidCase settings;
  settings.grid = {30, 60, 8, 0.03, 0};
  settings.parameters = {.Re = 200, .ramp = 1};
  FluidRun rising(settings);
  settings.parameters.ramp = 0;
  FluidRun at_once(settings);
  rising.run_to(0.5, 0.01);
  EXPECT_NEAR(rising.state().u[0].row(0, 29)[15], 0.5, 0.01);
  EXPECT_NEAR(rising.state().u[0].row(0, 29)[45], 0.5, 0.01);
  EXPECT_LT(rising.force()[1], 0.5);
  rising.run_to(15, 0.02);
  at_once.run_to(15, 0.02);
  EXPECT_NEAR(rising.force()[1] / at_once.force()[1], 1, 2e-3);
}

}  // namespace
}  // namespace pennon::dns

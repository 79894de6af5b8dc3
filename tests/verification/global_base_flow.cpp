// The steady flow of modes/global and the steady state of the simulation are one.
#include <gtest/gtest.h>

#include <cmath>

#include "modes/global/base_flow.hpp"
#include "tests/support/fluids.hpp"

namespace pennon::modes::global {
namespace {

constexpr double dt = 0.02;

test::FluidCase small_case(double Re) {
  test::FluidCase small;
  small.grid.n_rho = 24;
  small.grid.n_theta = 48;
  small.grid.R = 4;
  small.grid.wall_spacing = 0.03;
  small.parameters.Re = Re;
  small.tolerances = {1e-12, 1e-13, 1e-12, 20};
  return small;
}

PlaneParameters parameters_of(const test::FluidCase& simulation) {
  return {.Re = simulation.parameters.Re, .U = 0, .tau = 2 * dt / 3};
}

TEST(GlobalBaseFlow, IsTheStateAtWhichAStepOfTheSimulationChangesNothing) {
  const test::FluidCase simulation = small_case(100);
  test::FluidRun run(simulation);
  run.run_to(150, dt);
  const dns::FluidState& state = run.state();
  PlaneFlow<double> q(state.p.extent(), 2);
  q.u = {state.u[0], state.u[1]};
  q.p = state.p;
  EXPECT_LT(largest_residual(run.grid(), parameters_of(simulation), q, state.is_inflow), 1e-7);
  const BaseFlow base = base_flow(run.grid(), parameters_of(simulation), 2);
  const dns::Vector3 force =
      total_force(run.fluid(), wall_traction(run.fluid(), run.state()));
  EXPECT_NEAR(base.drag_coefficient, 2 * force[1], 1e-8);
  std::printf("residual %.3e drag %.12f %.12f its %d res %.3e\n",
              largest_residual(run.grid(), parameters_of(simulation), q, state.is_inflow),
              base.drag_coefficient, 2 * force[1], base.iterations, base.residual);
}

}  // namespace
}  // namespace pennon::modes::global

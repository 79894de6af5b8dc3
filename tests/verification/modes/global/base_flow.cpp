// The steady flow of modes/global and the steady state of the simulation are one.
#include <gtest/gtest.h>

#include <cmath>

#include "modes/global/equations/base_flow.hpp"
#include "tests/support/fluids.hpp"

namespace pennon::modes::global {
namespace {

constexpr double time_step = 0.02;

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
  return {.Re = simulation.parameters.Re, .U = 0, .dt_of_pressure = 2 * time_step / 3};
}

TEST(GlobalBaseFlow, IsTheStateAtWhichAStepOfTheSimulationChangesNothing) {
  const test::FluidCase simulation = small_case(100);
  test::FluidRun run(simulation);
  run.run_to(80, time_step);
  const dns::FluidState& state = run.state();
  PlaneFlow<double> q(state.p.extent(), 2);
  q.u = {state.u[0], state.u[1]};
  q.p = state.p;
  // Of the pressure, over the square of the smallest cells.
  constexpr double tolerance_of_simulation = 1e-7;
  EXPECT_LT(largest_residual(run.grid(), parameters_of(simulation), q, state.is_inflow),
            tolerance_of_simulation);
  const BaseFlow base = base_flow(run.grid(), parameters_of(simulation), 2);
  EXPECT_NEAR(base.drag_coefficient, 2 * run.force()[1], 1e-9);
  EXPECT_EQ(base.is_inflow, state.is_inflow);
}

TEST(GlobalBaseFlow, KnowsTheStepOfTheSimulation) {
  const dns::OGrid grid(small_case(100).grid);
  const BaseFlow with = base_flow(grid, {.Re = 100, .dt_of_pressure = 2 * time_step / 3}, 2);
  const BaseFlow without = base_flow(grid, {.Re = 100, .dt_of_pressure = 2e-3 * time_step}, 2);
  EXPECT_GT(std::abs(with.drag_coefficient - without.drag_coefficient), 1e-6);
}

TEST(GlobalBaseFlow, IsFoundAtReynoldsNumbersFrom10To10000) {
  const dns::OGrid grid(small_case(10).grid);
  double last_drag = 10;
  for (const double Re : {10.0, 1000.0, 10000.0}) {
    const BaseFlow base = base_flow(grid, {.Re = Re, .dt_of_pressure = 0.001}, 2);
    EXPECT_LT(base.residual, 1e-8) << Re;
    EXPECT_LT(base.drag_coefficient, last_drag) << Re;
    EXPECT_NEAR(base.tension.front(), base.drag_coefficient / 2, 1e-12);
    EXPECT_EQ(base.tension.back(), 0);
    last_drag = base.drag_coefficient;
  }
}

TEST(GlobalBaseFlow, DoesNotKnowOfACrossFlow) {
  const dns::OGrid grid(small_case(100).grid);
  const BaseFlow without = base_flow(grid, {.Re = 100, .dt_of_pressure = 0.01}, 2);
  const BaseFlow with = base_flow(grid, {.Re = 100, .U = 1, .dt_of_pressure = 0.01}, 3);
  EXPECT_NEAR(with.drag_coefficient, without.drag_coefficient, 1e-11);
}

}  // namespace
}  // namespace pennon::modes::global

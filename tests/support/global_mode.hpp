/// A global mode of a small coupled case, found by inverse iteration.
#pragma once

#include "modes/global/matrix_free/flow_mode.hpp"
#include "tests/support/coupled.hpp"

namespace pennon::test {

/// A flag on a coarse grid, in a flow so slow that the grid shows its modes; solved to rounding.
inline CoupledCase small_case() {
  CoupledCase small;
  small.grid = {.n_rho = 24, .n_theta = 48, .R = 4, .wall_spacing = 0.03};
  small.fluid.Re = 300;
  small.flag = {.mu = 0.3, .K_B = 1e-3, .K_S = 500, .damping = 0.02};
  small.tolerances = {.pressure = 1e-13, .velocity = 1e-14, .grid = 1e-13};
  small.coupling.tolerance = 1e-11;
  return small;
}

/// The mode next to a target, about the steady flow that the simulation has with steps of dt.
inline dns::FlowMode mode_near(const CoupledCase& simulation, double k_x, double dt,
                               std::complex<double> target) {
  using namespace modes::global;
  const dns::OGrid grid(simulation.grid);
  const PlaneParameters parameters{
      .Re = simulation.fluid.Re, .U = simulation.fluid.U, .dt_of_pressure = 2 * dt / 3};
  const BaseFlow base = base_flow(grid, parameters, k_x != 0 ? 3 : 2);
  const FlagOperator flag = flag_operator(dns::coupled_chord(grid), simulation.leading_edge,
                                          simulation.flag, base.forces, k_x, simulation.planes);
  const CoupledOperator coupled = coupled_operator(grid, base, flag, k_x);
  return flow_mode(base, flag, coupled, eigenpair_near(coupled.assembled(), target), k_x);
}

}  // namespace pennon::test

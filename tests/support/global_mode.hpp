/// A global mode of a small coupled case, found by inverse iteration.
#pragma once

#include "modes/global/flow_mode.hpp"
#include "tests/support/coupled.hpp"

namespace pennon::test {

/// The mode next to a target, about the steady flow that the simulation has with steps of dt.
inline dns::FlowMode mode_near(const CoupledCase& simulation, double k_x, double dt,
                               std::complex<double> target) {
  using namespace modes::global;
  const dns::OGrid grid(simulation.grid);
  const PlaneParameters parameters{
      .Re = simulation.fluid.Re, .U = simulation.fluid.U, .tau = 2 * dt / 3};
  const BaseFlow base = base_flow(grid, parameters, k_x != 0 ? 3 : 2);
  const FlagOperator flag = flag_operator(dns::coupled_chord(grid), simulation.leading_edge,
                                          simulation.flag, base.forces, k_x, simulation.planes);
  const CoupledOperator coupled = coupled_operator(grid, base, flag, k_x);
  return flow_mode(base, flag, coupled, eigenpair_near(coupled.A, coupled.B, target), k_x);
}

}  // namespace pennon::test

/// A simulation that starts as a small global mode.
#pragma once

#include "dns/coupling/coupling.hpp"
#include "dns/coupling/flow_mode.hpp"

namespace pennon::dns {

/// The state at t = 0 of a simulation with steps of dt: the steady flow plus amplitude times
/// Re[mode exp(i k_x x + lambda t)]. The members that hold earlier times are given the same sum at
/// t = -dt and -2 dt, so that the first step goes on as if steps of dt had led there. `amplitude`
/// is in L if the mode's largest displacement is 1. Preconditions: the mode is of the fluid's grid
/// and number of components, and a whole number of its waves fits the span. Throws SolverError
/// where the flag is displaced so far that no grid follows.
template <int dim>
CoupledState<dim> start_in_mode(Coupling<dim>&, const Fluid&, const Flag<dim>&, const FlowMode&,
                                double amplitude, double dt);

}  // namespace pennon::dns

/// A simulation that starts as a small global mode.
#pragma once

#include "dns/coupling/coupling.hpp"
#include "dns/coupling/flow_mode.hpp"

namespace pennon::dns {

/// At t = 0 the steady flow with amplitude Re[mode exp(i k_x x + lambda t)] added, as if steps of
/// dt had led there: what a step needs of times before is that of t = -dt and -2 dt. `amplitude` in
/// L if the mode's largest displacement is 1. Precondition: the mode is of the fluid's grid and
/// number of components, and a multiple of its wave fits the span. Throws SolverError where the
/// flag is displaced so far that no grid follows.
template <int dim>
CoupledState<dim> start_in_mode(Coupling<dim>&, const Fluid&, const Flag<dim>&, const FlowMode&,
                                double amplitude, double dt);

}  // namespace pennon::dns

/// Grid, steady flow and coupled operator of a case.
#pragma once

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/sensitivity.hpp"
#include "modes/global/study/settings.hpp"

namespace pennon::modes::global {

/// The flow in a plane that the settings, which are resolved, ask for.
PlaneParameters plane_parameters(const FlowParameters&, const Settings&);

/// Throws InputError where the settings, which are resolved, make no grid.
OGrid grid_of(const Settings&);

struct CoupledProblem {
  OGrid grid;
  BaseFlow base;
  std::vector<double> chord;  ///< y of the flag's nodes
  FlagOf flag_of;             ///< of the flag in the steady flow
  CoupledOperator coupled;
  double base_seconds = 0, operator_seconds = 0;
};

/// Precondition: the settings are resolved. Throws InputError as grid_of() does, and SolverError
/// where there is no steady flow or the flag is not held flat in it.
CoupledProblem coupled_problem(const FlagParameters&, const FlowParameters&, const Settings&);

}  // namespace pennon::modes::global

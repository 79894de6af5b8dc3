/// Stable equilibrium of a loaded flag: F(x) = 0 with a positive definite tangent, by Newton's
/// method down the potential energy, the loads raised in steps that shrink and grow with its
/// success.
#pragma once

#include "dns/flag/flag.hpp"

namespace pennon::dns {

struct EquilibriumSettings {
  /// Of the last change of any position, in L; where rounding forbids it, the first change below
  /// 1e-6 that is no smaller than the one before.
  double tolerance = 1e-11;
  int most_iterations = 200;  ///< at one load, each with a factorisation of the tangent
  double first_share = 1;     ///< of the loads, tried first
  double least_share = 1e-6;  ///< smallest rise of the loads before it gives up
};

struct EquilibriumSummary {
  int iterations = 0;
  int load_steps = 0;
};

/// Moves `x` to the equilibrium under the loads. Throws SolverError that says at which share of the
/// loads it stopped; `x` is then the last equilibrium found.
template <int dim>
EquilibriumSummary find_equilibrium(const Flag<dim>&, const FlagLoads<dim>&, NodeVectors<dim>& x,
                                    const EquilibriumSettings& = {});

}  // namespace pennon::dns

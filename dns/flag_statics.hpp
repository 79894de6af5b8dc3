/// Equilibrium of a loaded flag: F(x) = 0 by Newton's method with the exact tangent, the loads
/// raised in steps that shrink and grow with its success.
#pragma once

#include "dns/flag.hpp"

namespace pennon::dns {

struct EquilibriumSettings {
  double tolerance = 1e-11;  ///< of the last change of any position, in L
  int most_iterations =
      1000;                ///< at one load; many where a slender flag slides along a curved valley
  double first_share = 1;  ///< of the loads, tried first
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

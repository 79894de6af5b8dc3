#include "dns/flag_statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"

namespace pennon::dns {
namespace {

template <int dim>
FlagLoads<dim> scaled(const FlagLoads<dim>& loads, double share) {
  FlagLoads<dim> part = loads;
  part.gravity *= share;
  part.pressure *= share;
  part.node_forces *= share;
  return part;
}

// Newton's method. False where it does not converge.
template <int dim>
bool converge(const Flag<dim>& flag, const FlagLoads<dim>& loads, NodeVectors<dim>& x,
              TangentMatrix<dim>& tangent, const EquilibriumSettings& settings, int& iterations) {
  const auto forces_at = [&](const NodeVectors<dim>& here) {
    NodeVectors<dim> forces = flag.forces({here, here}, loads);
    for (int node = 0; node < flag.mesh().nodes(); ++node)
      if (flag.is_held()[static_cast<std::size_t>(node)]) forces.col(node).setZero();
    return forces;
  };
  NodeVectors<dim> forces = forces_at(x);
  for (int i = 0; i < settings.most_iterations; ++i, ++iterations) {
    tangent.set_zero();
    flag.add_tangent({x, x}, loads, 0, tangent);
    if (!tangent.factor()) return false;
    NodeVectors<dim> change = forces;
    tangent.solve(change);
    const double largest = change.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest) || largest > 1e3) return false;
    x += change;
    forces = forces_at(x);
    if (largest <= settings.tolerance) return true;
  }
  return false;
}

}  // namespace

template <int dim>
EquilibriumSummary find_equilibrium(const Flag<dim>& flag, const FlagLoads<dim>& loads,
                                    NodeVectors<dim>& x, const EquilibriumSettings& settings) {
  const auto tangent = flag.tangent_matrix();
  EquilibriumSummary summary;
  double reached = 0;
  double rise = settings.first_share;
  while (reached < 1) {
    rise = std::min(rise, 1 - reached);
    const double share = reached + rise;
    NodeVectors<dim> trial = x;
    if (converge(flag, scaled(loads, share), trial, *tangent, settings, summary.iterations)) {
      x = std::move(trial);
      reached = share;
      ++summary.load_steps;
      rise *= 2;
      continue;
    }
    rise /= 4;
    if (rise < settings.least_share)
      throw SolverError(
          fmt::format("no equilibrium of the flag was found beyond {:.4g} of the loads: "
                      "Newton's method fails even for a rise by {:.1e} of them; the flag "
                      "may buckle there, or have no stiffness against them",
                      reached, settings.least_share));
  }
  return summary;
}

template EquilibriumSummary find_equilibrium(const Flag<2>&, const FlagLoads<2>&, NodeVectors<2>&,
                                             const EquilibriumSettings&);
template EquilibriumSummary find_equilibrium(const Flag<3>&, const FlagLoads<3>&, NodeVectors<3>&,
                                             const EquilibriumSettings&);

}  // namespace pennon::dns

#include "dns/flag_statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"
#include "common/interrupt.hpp"

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

// Changes below this are left to Newton's method: they differ in energy by less than its rounding.
constexpr double newton_alone = 1e-6;

// Minimises the potential energy (that of the flag less the work of the loads, a follower pressure
// frozen at each iterate) by Newton's method. A change that would raise it is repeated with a
// multiple of the mass added to the tangent, ten times as much each time until it lowers it, and
// less again afterwards: from Newton's method to steepest descent and back (Levenberg and
// Marquardt). So it finds stable equilibria, also beyond a bifurcation. False where it does not
// converge.
template <int dim>
class Descent {
 public:
  Descent(const Flag<dim>& flag, const FlagLoads<dim>& loads, TangentMatrix<dim>& tangent)
      : flag_(flag),
        loads_(loads),
        tangent_(tangent),
        still_(NodeVectors<dim>::Zero(dim, flag.mesh().nodes())) {}

  bool converge(NodeVectors<dim>& x, const EquilibriumSettings& settings, int& iterations) {
    double added_mass = 0;
    for (int i = 0; i < settings.most_iterations; ++i) {
      ++iterations;
      stop_if_interrupted("nothing was written; run the same command again");
      const NodeVectors<dim> forces = forces_at(x);
      NodeVectors<dim> change = forces;
      tangent_.set_zero();
      flag_.add_tangent({x, x}, loads_, added_mass, tangent_);
      const bool is_regular = tangent_.factor();
      if (is_regular) tangent_.solve(change);
      const double largest = change.cwiseAbs().maxCoeff();
      if (is_regular && std::isfinite(largest)) {
        const bool is_last = added_mass == 0 && largest <= settings.tolerance;
        const bool is_near = added_mass == 0 && largest <= newton_alone;
        if (is_near || lowers_energy(x, change)) {
          x += change;
          if (is_last) return true;
          added_mass = added_mass > least_mass(forces, change) ? added_mass / 10 : 0;
          continue;
        }
      }
      added_mass = std::max(10 * added_mass, is_regular && std::isfinite(largest) && largest > 0
                                                 ? least_mass(forces, change)
                                                 : 1.0);
      if (!std::isfinite(added_mass)) return false;
    }
    return false;
  }

 private:
  NodeVectors<dim> forces_at(const NodeVectors<dim>& x) const {
    NodeVectors<dim> forces = flag_.forces({x, x}, loads_);
    flag_.clear_held(forces);
    return forces;
  }

  bool lowers_energy(const NodeVectors<dim>& x, const NodeVectors<dim>& change) const {
    const double before = flag_.energies(x, still_, loads_).total();
    const double after = flag_.energies(x + change, still_, loads_).total();
    const double work = flag_.load_forces({x, x}, loads_).cwiseProduct(change).sum();
    const double rounding = 1e-14 * (std::abs(before) + std::abs(after) + std::abs(work));
    return after - work <= before + rounding;
  }

  // The mass factor that matters beside the tangent for this change.
  double least_mass(const NodeVectors<dim>& forces, const NodeVectors<dim>& change) const {
    const double inertia = change.colwise().squaredNorm().dot(flag_.mass());
    return 0.01 * std::abs(forces.cwiseProduct(change).sum()) / inertia;
  }

  const Flag<dim>& flag_;
  const FlagLoads<dim>& loads_;
  TangentMatrix<dim>& tangent_;
  NodeVectors<dim> still_;
};

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
    const FlagLoads<dim> part = scaled(loads, share);
    if (Descent<dim>(flag, part, *tangent).converge(trial, settings, summary.iterations)) {
      x = std::move(trial);
      reached = share;
      ++summary.load_steps;
      rise *= 2;
      continue;
    }
    rise /= 4;
    if (rise < settings.least_share)
      throw SolverError(fmt::format(
          "no equilibrium of the flag was found beyond {:.4g} of the loads: the search fails "
          "even for a rise by {:.1e} of them; the flag may have no stiffness against them",
          reached, settings.least_share));
  }
  return summary;
}

template EquilibriumSummary find_equilibrium(const Flag<2>&, const FlagLoads<2>&, NodeVectors<2>&,
                                             const EquilibriumSettings&);
template EquilibriumSummary find_equilibrium(const Flag<3>&, const FlagLoads<3>&, NodeVectors<3>&,
                                             const EquilibriumSettings&);

}  // namespace pennon::dns

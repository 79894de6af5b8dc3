#include "dns/flag/statics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

// How far to leave an equilibrium that is not stable, in L.
constexpr double nudge = 1e-3;

// x moved by `change`, but so that the segments along the chord turn where a straight move would
// stretch them: the lengths change as they do to first order. A flag that turns by much keeps its
// tension, however stiff its stretch is; along straight lines it could turn by (K_B/K_S)^1/4 only.
// With a held trailing edge, which the turned segments would miss, the move is straight.
template <int dim>
NodeVectors<dim> moved(const Flag<dim>& flag, const NodeVectors<dim>& x,
                       const NodeVectors<dim>& change) {
  const FlagMesh& mesh = flag.mesh();
  NodeVectors<dim> result = x + change;
  if (mesh.edges().trailing != Edge::free) return result;
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 1; j < mesh.chord_nodes(); ++j) {
      const int from = mesh.index(i, j - 1);
      const int to = mesh.index(i, j);
      const Eigen::Matrix<double, dim, 1> before = x.col(to) - x.col(from);
      const Eigen::Matrix<double, dim, 1> added = change.col(to) - change.col(from);
      const double length = before.norm() + before.dot(added) / before.norm();
      result.col(to) = result.col(from) + length * (before + added).normalized();
    }
  NodeVectors<dim> move = result - x;
  flag.clear_held(move);  // of the sides: not even by rounding
  return x + move;
}

// Minimises the potential energy (that of the flag less the work of the loads, a follower pressure
// frozen at each iterate) by Newton's method. A multiple of the mass is added to the tangent until
// it is positive definite, so that the change leads downhill, and until the change lowers the
// energy (Levenberg and Marquardt); less again afterwards. So it finds stable equilibria, also
// beyond a bifurcation. False where it does not converge.
template <int dim>
class Descent {
 public:
  Descent(const Flag<dim>& flag, const FlagLoads<dim>& loads, TangentMatrix<dim>& tangent)
      : flag_(flag),
        loads_(loads),
        tangent_(tangent),
        still_(NodeVectors<dim>::Zero(dim, flag.mesh().nodes())) {}

  bool converge(NodeVectors<dim>& x, const EquilibriumSettings& settings, int& iterations) {
    // Of the mode that is the first to lose its stability, by its order of magnitude.
    const double soft_mass = flag_.material().bending().stiffness / flag_.material().mu;
    double added_mass = 0;
    bool was_indefinite = false;  // here, with less mass
    double last_near = std::numeric_limits<double>::infinity();
    for (int i = 0; i < settings.most_iterations && std::isfinite(added_mass); ++i) {
      ++iterations;
      stop_if_interrupted("nothing was written; run the same command again");
      tangent_.set_zero();
      flag_.add_tangent({x, x}, loads_, added_mass, tangent_);
      if (!tangent_.factor_if_definite()) {
        was_indefinite = true;
        added_mass = std::max(3 * added_mass, soft_mass);
        continue;
      }
      const NodeVectors<dim> forces = forces_at(x);
      NodeVectors<dim> change = forces;
      tangent_.solve(change);
      double largest = change.cwiseAbs().maxCoeff();
      if (!std::isfinite(largest)) return false;
      if (was_indefinite && largest <= settings.tolerance) {
        change = softest_change();
        largest = nudge;
      }
      const bool is_near = added_mass == 0 && largest <= newton_alone;
      NodeVectors<dim> trial = moved(flag_, x, change);
      if (!is_near && !lowers_energy(x, trial)) {
        added_mass = std::max(10 * added_mass, least_mass(forces, change));
        continue;
      }
      x = std::move(trial);
      // Where rounding forbids the tolerance, the changes stop shrinking.
      if (is_near && (largest <= settings.tolerance || largest >= last_near)) return true;
      if (is_near) last_near = largest;
      if (was_indefinite)
        added_mass /= 2;
      else
        added_mass = added_mass > least_mass(forces, change) ? added_mass / 10 : 0;
      was_indefinite = false;
    }
    return false;
  }

 private:
  NodeVectors<dim> forces_at(const NodeVectors<dim>& x) const {
    NodeVectors<dim> forces = flag_.forces({x, x}, loads_);
    flag_.clear_held(forces);
    return forces;
  }

  // The mode that the factored tangent resists least, by inverse iteration from a shape that no
  // mode is orthogonal to but by chance.
  NodeVectors<dim> softest_change() const {
    constexpr int iterations = 10;
    NodeVectors<dim> shape = flag_.rest();
    for (Eigen::Index n = 0; n < shape.size(); ++n)
      shape.data()[n] = std::sin(static_cast<double>(n + 1));
    for (int iteration = 0; iteration < iterations; ++iteration) {
      shape = shape * flag_.mass().asDiagonal();
      flag_.clear_held(shape);
      tangent_.solve(shape);
      shape /= shape.cwiseAbs().maxCoeff();
    }
    return nudge * shape;
  }

  bool lowers_energy(const NodeVectors<dim>& x, const NodeVectors<dim>& trial) const {
    const double before = flag_.energies(x, still_, loads_).total();
    const double after = flag_.energies(trial, still_, loads_).total();
    const double work = flag_.load_forces({x, x}, loads_).cwiseProduct(trial - x).sum();
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

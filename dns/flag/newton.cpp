#include "dns/flag/newton.hpp"

#include <cmath>
#include <limits>

#include "common/parallel/interrupted_step.hpp"

namespace pennon::dns {
namespace {

// Where the solver of the added mass, preconditioned by the factors of an earlier tangent, takes
// more iterations than this, new factors are cheaper.
constexpr int most_solver_iterations = 8;

}  // namespace

template <int dim>
void FlagEquation<dim>::pose(const FlagState<dim>& state, const BackwardDifference& D,
                             double step) {
  // The acceleration is D.next^2 x and the rest: that rest over -D.next^2 is where inertia leads.
  velocity_rest = D.last * state.x;
  inertial = D.last * state.v;
  if (D.before != 0) {
    velocity_rest += D.before * state.previous_x;
    inertial += D.before * state.previous_v;
  }
  inertial = -(D.next * velocity_rest + inertial) / (D.next * D.next);
  mass_factor = D.next * D.next;
  velocity_factor = D.next;
  pairing = Pairing::end;
  dt = step;
}

template <int dim>
FlagNewton<dim>::FlagNewton(const Flag<dim>& flag, const NewtonSettings& settings)
    : flag_(flag), settings_(settings), tangent_(flag.tangent_matrix()) {}

template <int dim>
bool FlagNewton<dim>::solve(const NodeVectors<dim>& start, const FlagEquation<dim>& equation,
                            NodeVectors<dim>& x, NodeVectors<dim>& v, StepSummary& summary) {
  bool must_factor = settings_.contraction == 0 || factored_mass_ != equation.mass_factor;
  last_change_ = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < settings_.most_iterations; ++iteration) {
    v = equation.velocity_factor * x + equation.velocity_rest;
    const FlagStep<dim> step{start, x, equation.pairing, equation.dt, &v, equation.velocity_factor};
    if (must_factor || must_fill_) {
      tangent_->set_zero();
      flag_.add_tangent(step, equation.loads, equation.mass_factor, *tangent_);
      must_fill_ = false;
    }
    if (must_factor) {
      ranks::stop_if_interrupted_alone();
      factored_mass_ = 0;
      ++summary.factorisations;
      if (!tangent_->factor()) return false;
      factored_mass_ = equation.mass_factor;
    }
    flag_.evaluate_forces(step, equation.loads, change_);
    inertia_ = equation.mass_factor * (x - equation.inertial);
    if (equation.added_mass) equation.added_mass->subtract_force(inertia_, change_);
    change_ -= inertia_ * flag_.mass().asDiagonal();
    flag_.clear_held(change_);
    ranks::stop_if_interrupted_alone();
    int solver_iterations = 0;
    if (equation.added_mass)
      solver_iterations = equation.added_mass->solve(*tangent_, equation.mass_factor, change_);
    else
      tangent_->solve(change_);
    x += change_;
    ++summary.iterations;
    const double largest = change_.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) return false;
    // Below the tolerance, or below that of a flag by itself and no smaller than before: rounding.
    const bool stalls = largest > 0.5 * last_change_ && largest <= NewtonSettings{}.tolerance;
    if (largest <= settings_.tolerance || stalls) {
      v = equation.velocity_factor * x + equation.velocity_rest;
      return true;
    }
    const bool is_slow = largest > settings_.contraction * last_change_;
    must_factor = equation.added_mass
                      ? settings_.contraction == 0 || solver_iterations > most_solver_iterations
                      : is_slow;
    must_fill_ = is_slow;
    last_change_ = largest;
  }
  factored_mass_ = 0;
  return false;
}

template <int dim>
std::optional<KeptTangent> FlagNewton<dim>::kept_tangent() const {
  if (settings_.contraction == 0 || factored_mass_ == 0) return std::nullopt;
  return KeptTangent{factored_mass_, tangent_->factors()};
}

template <int dim>
bool FlagNewton<dim>::keep(const KeptTangent& tangent) {
  factored_mass_ = 0;
  if (!tangent_->factor_again(tangent.factors)) return false;
  factored_mass_ = tangent.mass_factor;
  must_fill_ = false;
  return true;
}

template struct FlagEquation<2>;
template struct FlagEquation<3>;
template class FlagNewton<2>;
template class FlagNewton<3>;

}  // namespace pennon::dns

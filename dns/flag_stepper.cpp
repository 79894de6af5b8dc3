#include "dns/flag_stepper.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace pennon::dns {

// A step as an equation for the end position x: mass_factor M (x - inertial) = F(start, x), after
// which v = velocity_factor x + velocity_rest.
template <int dim>
struct FlagStepper<dim>::Equation {
  const NodeVectors<dim>& start;
  NodeVectors<dim> guess;
  NodeVectors<dim> inertial;
  double mass_factor;
  double velocity_factor;
  NodeVectors<dim> velocity_rest;
  FlagLoads<dim> loads;
  Pairing pairing;
  double dt;

  NodeVectors<dim> velocity(const NodeVectors<dim>& end) const {
    return velocity_factor * end + velocity_rest;
  }
};

template <int dim>
FlagStepper<dim>::FlagStepper(const Flag<dim>& flag, TimeScheme scheme,
                              const NewtonSettings& settings)
    : flag_(flag), scheme_(scheme), settings_(settings), tangent_(flag.tangent_matrix()) {}

template <int dim>
FlagState<dim> FlagStepper<dim>::start() const {
  return start(flag_.rest());
}

template <int dim>
FlagState<dim> FlagStepper<dim>::start(NodeVectors<dim> x) const {
  FlagState<dim> state;
  state.v = NodeVectors<dim>::Zero(dim, x.cols());
  state.x = std::move(x);
  return state;
}

template <int dim>
auto FlagStepper<dim>::energy_conserving(const FlagState<dim>& state, const LoadsAt& loads,
                                         double dt) const -> Equation {
  // v_1 = 2 (x_1 - x_0)/dt - v_0, so M (v_1 - v_0)/dt = 2/dt^2 M (x_1 - x_0 - dt v_0).
  NodeVectors<dim> drifted = state.x + dt * state.v;
  return {state.x,
          drifted,
          drifted,
          2 / (dt * dt),
          2 / dt,
          -2 / dt * state.x - state.v,
          loads(state.t + dt / 2),
          Pairing::discrete_gradient,
          dt};
}

template <int dim>
auto FlagStepper<dim>::backward_difference(const FlagState<dim>& state, const LoadsAt& loads,
                                           double dt) const -> Equation {
  // d/dt of q at the end: now q_1 + before q_0 + earlier q_-1, with r the ratio of this step to the
  // last.
  const double r = dt / state.previous_dt;
  const double now = (1 + 2 * r) / ((1 + r) * dt);
  const double before = -(1 + r) / dt;
  const double earlier = r * r / ((1 + r) * dt);
  const NodeVectors<dim> velocity_rest = before * state.x + earlier * state.previous_x;
  const NodeVectors<dim> acceleration_rest =
      now * velocity_rest + before * state.v + earlier * state.previous_v;
  return {state.x,
          state.x + dt * state.v + dt * r / 2 * (state.v - state.previous_v),
          -acceleration_rest / (now * now),
          now * now,
          now,
          velocity_rest,
          loads(state.t + dt),
          Pairing::end,
          dt};
}

template <int dim>
bool FlagStepper<dim>::solve(const Equation& equation, NodeVectors<dim>& x, StepSummary& summary) {
  const auto hold = [&](NodeVectors<dim>& vectors) {
    for (int node = 0; node < flag_.mesh().nodes(); ++node)
      if (flag_.is_held()[static_cast<std::size_t>(node)]) vectors.col(node).setZero();
  };
  bool must_factor = settings_.contraction == 0 || factored_mass_ != equation.mass_factor;
  last_change_ = std::numeric_limits<double>::infinity();
  for (int iteration = 0; iteration < settings_.most_iterations; ++iteration) {
    const NodeVectors<dim> v = equation.velocity(x);
    const FlagStep<dim> step{equation.start, x,  equation.pairing,
                             equation.dt,    &v, equation.velocity_factor};
    if (must_factor) {
      tangent_->set_zero();
      flag_.add_tangent(step, equation.loads, equation.mass_factor, *tangent_);
      factored_mass_ = 0;
      ++summary.factorisations;
      if (!tangent_->factor()) return false;
      factored_mass_ = equation.mass_factor;
    }
    NodeVectors<dim> change = flag_.forces(step, equation.loads) - equation.mass_factor *
                                                                       (x - equation.inertial) *
                                                                       flag_.mass().asDiagonal();
    hold(change);
    tangent_->solve(change);
    x += change;
    ++summary.iterations;
    const double largest = change.cwiseAbs().maxCoeff();
    if (!std::isfinite(largest)) return false;
    if (largest <= settings_.tolerance) return true;
    must_factor = largest > settings_.contraction * last_change_;
    last_change_ = largest;
  }
  factored_mass_ = 0;
  return false;
}

template <int dim>
bool FlagStepper<dim>::try_advance(FlagState<dim>& state, const LoadsAt& loads, double dt,
                                   StepSummary& summary) {
  const bool has_history = state.previous_dt > 0;
  const Equation equation = scheme_ == TimeScheme::backward_difference && has_history
                                ? backward_difference(state, loads, dt)
                                : energy_conserving(state, loads, dt);
  NodeVectors<dim> x = equation.guess;
  for (int node = 0; node < flag_.mesh().nodes(); ++node)
    if (flag_.is_held()[static_cast<std::size_t>(node)]) x.col(node) = state.x.col(node);
  if (!solve(equation, x, summary)) return false;
  state.dissipated += flag_.stretch().dissipated(state.x, x, dt);
  const FlagStep<dim> mean{state.x, x, Pairing::discrete_gradient};
  state.work += flag_.load_forces(mean, equation.loads).cwiseProduct(x - state.x).sum();
  NodeVectors<dim> v = equation.velocity(x);
  state.previous_x = std::move(state.x);
  state.previous_v = std::move(state.v);
  state.previous_dt = dt;
  state.x = std::move(x);
  state.v = std::move(v);
  state.t += dt;
  return true;
}

template <int dim>
StepSummary FlagStepper<dim>::advance(FlagState<dim>& state, const LoadsAt& loads, double dt) {
  assert(dt > 0);
  StepSummary summary;
  const double end = state.t + dt;
  const double smallest_part = std::ldexp(dt, -settings_.most_halvings);
  summary.parts = 0;
  for (double part = dt; end - state.t > 0.5 * smallest_part;) {
    part = std::min(part, end - state.t);
    if (try_advance(state, loads, part, summary)) {
      ++summary.parts;
      continue;
    }
    part /= 2;
    if (part < smallest_part)
      throw SolverError(
          fmt::format("the flag's step at t = {:.6g} did not converge even with {:.3g}, 1/{} of "
                      "the step: the last "
                      "Newton iteration moved a node by {:.3g} L; try a smaller dt, more damping, "
                      "or more nodes",
                      state.t, smallest_part, 1 << settings_.most_halvings, last_change_));
  }
  if (summary.parts == 1) state.t = end;
  return summary;
}

template class FlagStepper<2>;
template class FlagStepper<3>;

}  // namespace pennon::dns

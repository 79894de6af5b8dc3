#include "dns/flag/stepper.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cmath>

#include "common/errors.hpp"

namespace pennon::dns {

template <int dim>
FlagStepper<dim>::FlagStepper(const Flag<dim>& flag, TimeScheme scheme,
                              const NewtonSettings& settings)
    : flag_(flag), scheme_(scheme), settings_(settings), newton_(flag, settings) {}

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
void FlagStepper<dim>::pose_energy_conserving(const FlagState<dim>& state, const LoadsAt& loads,
                                              double dt) {
  // v_1 = 2 (x_1 - x_0)/dt - v_0, so M (v_1 - v_0)/dt = 2/dt^2 M (x_1 - x_0 - dt v_0).
  equation_.inertial = state.x + dt * state.v;
  equation_.guess = equation_.inertial;
  equation_.velocity_rest = -2 / dt * state.x - state.v;
  equation_.mass_factor = 2 / (dt * dt);
  equation_.velocity_factor = 2 / dt;
  equation_.loads = loads(state.t + dt / 2);
  equation_.pairing = Pairing::discrete_gradient;
  equation_.dt = dt;
}

template <int dim>
void FlagStepper<dim>::pose_backward_difference(const FlagState<dim>& state, const LoadsAt& loads,
                                                double dt) {
  equation_.pose(state, BackwardDifference(dt, state.previous_dt), dt);
  const double r = dt / state.previous_dt;
  equation_.guess = state.x + dt * state.v + dt * r / 2 * (state.v - state.previous_v);
  equation_.loads = loads(state.t + dt);
}

template <int dim>
bool FlagStepper<dim>::try_advance(FlagState<dim>& state, const LoadsAt& loads, double dt,
                                   StepSummary& summary) {
  if (scheme_ == TimeScheme::backward_difference && state.previous_dt > 0)
    pose_backward_difference(state, loads, dt);
  else
    pose_energy_conserving(state, loads, dt);
  change_ = equation_.guess - state.x;
  flag_.clear_held(change_);
  x_ = state.x + change_;
  if (!newton_.solve(state.x, equation_, x_, v_, summary)) return false;
  state.dissipated += flag_.stretch().dissipated(state.x, x_, dt);
  const FlagStep<dim> mean{state.x, x_, Pairing::discrete_gradient};
  flag_.evaluate_load_forces(mean, equation_.loads, change_);
  state.work += change_.cwiseProduct(x_ - state.x).sum();
  // The buffers rotate: the new state, the one before, and work space for the next.
  state.previous_x.swap(state.x);
  state.previous_v.swap(state.v);
  state.previous_dt = dt;
  state.x.swap(x_);
  state.v.swap(v_);
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
                      state.t, smallest_part, 1 << settings_.most_halvings, newton_.last_change()));
  }
  if (summary.parts == 1) state.t = end;
  return summary;
}

template class FlagStepper<2>;
template class FlagStepper<3>;

}  // namespace pennon::dns

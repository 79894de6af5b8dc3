/// Time steps of the flag by itself: M dv/dt = F(x, t), dx/dt = v, implicit, by Newton's method
/// with the exact tangent. Second order.
///
/// - energy_conserving: x_1 - x_0 = dt (v_0 + v_1)/2, M (v_1 - v_0)/dt = F(x_0, x_1) with the
///   discrete gradient (step.hpp). Total energy, momentum and angular momentum of a free flag stay
///   constant to the tolerance of Newton's method, whatever the length of the step.
/// - backward_difference: v_1 and dv_1/dt by the second-order backward difference of unequal steps
///   (3.2), as for the fluid. The first step after a start is an energy-conserving one.
#pragma once

#include <functional>
#include <optional>

#include "dns/flag/flag.hpp"
#include "dns/flag/newton.hpp"

namespace pennon::dns {

enum class TimeScheme { energy_conserving, backward_difference };

template <int dim>
class FlagStepper {
 public:
  FlagStepper(const Flag<dim>& flag, TimeScheme scheme, const NewtonSettings& settings = {});

  /// The flag at rest at t = 0, or displaced without velocity.
  FlagState<dim> start() const;
  FlagState<dim> start(NodeVectors<dim> x) const;

  /// Loads at a time.
  using LoadsAt = std::function<FlagLoads<dim>(double t)>;

  /// Advances by dt. Throws SolverError where even the smallest part of the step does not converge:
  /// when and how far it came; the state is then that of the last part that did.
  StepSummary advance(FlagState<dim>&, const LoadsAt&, double dt);

  /// See FlagNewton.
  std::optional<KeptTangent> kept_tangent() const { return newton_.kept_tangent(); }
  bool keep(const KeptTangent& tangent) { return newton_.keep(tangent); }

 private:
  bool try_advance(FlagState<dim>&, const LoadsAt&, double dt, StepSummary&);
  void pose_energy_conserving(const FlagState<dim>&, const LoadsAt&, double dt);
  void pose_backward_difference(const FlagState<dim>&, const LoadsAt&, double dt);

  const Flag<dim>& flag_;
  TimeScheme scheme_;
  NewtonSettings settings_;
  FlagNewton<dim> newton_;
  FlagEquation<dim> equation_;
  NodeVectors<dim> x_, v_, change_;  // of the step that is being solved
};

}  // namespace pennon::dns

/// Time steps of the flag by itself: M dv/dt = F(x, t), dx/dt = v, implicit, by Newton's method
/// with the exact tangent. Second order.
///
///   energy_conserving    x_1 - x_0 = dt (v_0 + v_1)/2,  M (v_1 - v_0)/dt = F(x_0, x_1) by the
///   discrete gradient:
///                        total energy, momentum and angular momentum of a free flag stay to the
///                        tolerance of Newton's method, whatever the step
///   backward_difference  v_1 and dv_1/dt by the second-order backward difference of unequal steps,
///   as the fluid's
///                        (3.2); the first step after a start is an energy-conserving one
#pragma once

#include <functional>
#include <memory>

#include "dns/flag.hpp"

namespace pennon::dns {

enum class TimeScheme { energy_conserving, backward_difference };

struct NewtonSettings {
  double tolerance = 1e-10;  ///< of the last change of any position, in L
  int most_iterations = 25;
  int most_halvings = 12;  ///< of a step that does not converge
  /// The tangent is factored anew when an iteration shrinks the change by less than this. 0:
  /// always.
  double contraction = 0;
};

/// All that is advanced, saved and restarted.
template <int dim>
struct FlagState {
  double t = 0;
  NodeVectors<dim> x, v;
  /// The step before, for backward differences; previous_dt = 0: none yet.
  NodeVectors<dim> previous_x, previous_v;
  double previous_dt = 0;
  double dissipated = 0;  ///< by the damping since the start
  double work = 0;        ///< of the loads (gravity is an energy of its own) since the start
};

struct StepSummary {
  int iterations = 0;  ///< of Newton's method, all parts of the step together
  int factorisations = 0;
  int parts = 1;  ///< the step was halved until this many did it
};

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

  /// Has the next step factor its own tangent, so that what follows depends on the state alone.
  void forget_tangent() { factored_mass_ = 0; }

 private:
  // A step as an equation for the end position x: mass_factor M (x - inertial) = F(start, x), after
  // which v = velocity_factor x + velocity_rest.
  struct Equation {
    NodeVectors<dim> guess, inertial, velocity_rest;
    double mass_factor = 0;
    double velocity_factor = 0;
    FlagLoads<dim> loads;
    Pairing pairing = Pairing::end;
    double dt = 0;
  };
  bool try_advance(FlagState<dim>&, const LoadsAt&, double dt, StepSummary&);
  bool solve(const NodeVectors<dim>& start, StepSummary&);
  void pose_energy_conserving(const FlagState<dim>&, const LoadsAt&, double dt);
  void pose_backward_difference(const FlagState<dim>&, const LoadsAt&, double dt);

  const Flag<dim>& flag_;
  TimeScheme scheme_;
  NewtonSettings settings_;
  std::unique_ptr<TangentMatrix<dim>> tangent_;
  Equation equation_;
  NodeVectors<dim> x_, v_, change_;  // of the step that is being solved
  double factored_mass_ = 0;         // the mass factor of the factored tangent; 0: none
  double last_change_ = 0;           // of the last Newton iteration that failed, for the message
};

}  // namespace pennon::dns

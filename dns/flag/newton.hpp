/// Newton's method, with the exact tangent, for the end of an implicit step of a flag:
///
///   mass_factor (M + M_a) (x - inertial) = F(start, x),   v = velocity_factor x + velocity_rest,
///
/// M_a the added mass of a fluid, where the step has one.
#pragma once

#include <memory>
#include <optional>

#include "dns/flag/added_inertia.hpp"
#include "dns/flag/flag.hpp"
#include "dns/flag/state.hpp"
#include "dns/flag/tangent_matrix.hpp"
#include "dns/numerics/backward_difference.hpp"

namespace pennon::dns {

struct NewtonSettings {
  double tolerance = 1e-10;  ///< of the last change of any position, in L
  int most_iterations = 25;
  int most_halvings = 12;  ///< of a step that does not converge
  /// The tangent is filled anew where the change of an iteration is more than this share of the
  /// change before, and then also factored anew (with an added mass: where the solver of the added
  /// mass takes many iterations with the factors at hand). 0: in every iteration.
  double contraction = 0;
};

/// NewtonSettings::contraction as simulations have it. In two dimensions factoring the tangent
/// costs no more than solving with it, so that every iteration has its own.
template <int dim>
inline constexpr double usual_contraction = dim == 2 ? 0.0 : 0.1;

struct StepSummary {
  int iterations = 0;  ///< of Newton's method, all parts of the step together
  int factorisations = 0;
  int parts = 1;  ///< the step was halved until this many did it
};

template <int dim>
struct FlagEquation {
  NodeVectors<dim> guess, inertial, velocity_rest;
  double mass_factor = 0;
  double velocity_factor = 0;
  FlagLoads<dim> loads;
  Pairing pairing = Pairing::end;
  double dt = 0;
  AddedInertia<dim>* added_mass = nullptr;  ///< none: the flag by itself

  /// Sets all but the guess and the loads, for a step whose v and dv/dt at its end are backward
  /// differences.
  void pose(const FlagState<dim>&, const BackwardDifference&, double dt);
};

/// The factored tangent with which the next solution begins where it does not factor its own.
struct KeptTangent {
  double mass_factor = 0;
  TangentFactors factors;
};

template <int dim>
class FlagNewton {
 public:
  FlagNewton(const Flag<dim>&, const NewtonSettings&);

  /// From x to the end position; v becomes its velocity. False where it does not converge. Throws
  /// Interrupted (interrupted_step.hpp).
  bool solve(const NodeVectors<dim>& start, const FlagEquation<dim>&, NodeVectors<dim>& x,
             NodeVectors<dim>& v, StepSummary&);

  void set_tolerance(double tolerance) { settings_.tolerance = tolerance; }
  double last_change() const { return last_change_; }  ///< of an iteration that failed
  /// A new step: the next solution has a tangent of its own. Its factors may be of an earlier one
  /// where there is an added mass, whose solver makes up for it.
  void begin_step() { must_fill_ = true; }
  /// Has the next solution factor its own tangent, so that what follows depends on the state alone.
  void forget_tangent() { factored_mass_ = 0; }

  /// Beside the state the only thing on which the next solution depends; none where the next one
  /// factors its own.
  std::optional<KeptTangent> kept_tangent() const;
  /// The next solution is that of the solver that kept it. False where it is of another flag.
  bool keep(const KeptTangent&);

 private:
  const Flag<dim>& flag_;
  NewtonSettings settings_;
  std::unique_ptr<TangentMatrix<dim>> tangent_;
  NodeVectors<dim> change_, inertia_;
  bool must_fill_ = true;
  double factored_mass_ = 0;  // the mass factor of the factored tangent; 0: none
  double last_change_ = 0;
};

}  // namespace pennon::dns

/// The flag and the fluid advanced together (section 3.3), implicitly coupled.
///
/// In a step the fluid's grid, convection and friction follow the flag as extrapolated from the
/// last two steps; the pressure and the flag's motion at the end of the step are those that agree:
///
///   M a = F(x) + friction + A [p],   [p] = the fluid's answer to v
///
/// with x, v and a by the same backward differences as the fluid, and [p] the pressure below less
/// that above. They are found by passes. In each the flag is solved with the flat fluid's added
/// mass (added_mass.hpp) under the reduced jump g = [p] + Pi phi, which is nearly the same whatever
/// the flag's acceleration; the fluid answers with [p]; Anderson's acceleration gives the next g.
/// docs/theory/coupling.md derives this and shows how it converges.
#pragma once

#include "dns/coupling/added_mass.hpp"
#include "dns/coupling/settings.hpp"
#include "dns/flag/flag.hpp"
#include "dns/flag/newton.hpp"
#include "dns/fluid/equations/wall_forces.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/fluid/forces.hpp"
#include "dns/numerics/anderson.hpp"

namespace pennon::dns {

/// What is advanced, saved and restarted. The flag is the same on every rank.
template <int dim>
struct CoupledState {
  FluidState fluid;
  FlagState<dim> flag;
  /// g = [p] + Pi phi, in rho_f V^2, at the end of the last step and of the one before; empty
  /// before there is one. (After advance_held() it is [p], as the flag then does not accelerate.)
  SegmentValues reduced_jump, previous_reduced_jump;
  double power = 0;  ///< of the fluid and the outer force on the flag, now
};

struct CoupledStepSummary {
  FluidStepSummary fluid;
  int passes = 0;
  int flag_iterations = 0;
  int flag_factorisations = 0;
  double residual = 0;      ///< of the last pass, as the tolerance has it
  double flag_seconds = 0;  ///< of all passes
};

template <int dim>
class Coupling {
 public:
  /// `flag`: of the mesh that coupled_chord() and the fluid's planes give; `gravity` in V^2/L.
  Coupling(Fluid&, const Flag<dim>& flag, const Eigen::Matrix<double, dim, 1>& gravity,
           const CouplingSettings&);

  /// The flag at rest at x, in the uniform stream started impulsively at t.
  CoupledState<dim> start(const NodeVectors<dim>& x, double t);

  /// Advances by dt. Throws SolverError as Fluid::advance() does, and if the passes do not
  /// converge.
  CoupledStepSummary advance(CoupledState<dim>&, double dt);
  /// The same with the flag held where it is.
  CoupledStepSummary advance_held(CoupledState<dim>&, double dt);

  /// Sets the forces on the nodes, beside those of the fluid and of gravity, at the end of the next
  /// steps: dim x nodes, in rho_f V^2 L^2; empty: none.
  void set_outer_force(NodeVectors<dim> force) { outer_force_ = std::move(force); }

  /// Has the next step factor its own tangent, so that what follows depends on the state alone.
  void forget_tangent() { newton_.forget_tangent(); }
  /// See FlagNewton.
  std::optional<KeptTangent> kept_tangent() const { return newton_.kept_tangent(); }
  bool keep(const KeptTangent& tangent) { return newton_.keep(tangent); }

  /// The fluid's wall, of the planes of this rank, where the flag is at x.
  WallShape wall_of(const NodeVectors<dim>& x) const;

 private:
  void place_wall(const NodeVectors<dim>& x, WallShape&) const;
  void find_velocity_ahead(const CoupledState<dim>&, const BackwardDifference&,
                           NodeVectors<dim>& velocity) const;
  void place_wall_ahead(const CoupledState<dim>&, const NodeVectors<dim>& velocity,
                        const BackwardDifference&, WallShape&) const;
  template <class Append>
  const std::vector<double>& gather(const Append&);
  void find_areas(NodeVectors<dim>& areas);
  void find_fixed_forces(NodeVectors<dim>& forces);
  void find_jump(const FluidState&, SegmentValues& jump);
  void move_wall(const NodeVectors<dim>& v);
  void guess_reduced_jump(const CoupledState<dim>&, const BackwardDifference&,
                          SegmentValues& g) const;
  void solve_flag(const CoupledState<dim>&, CoupledStepSummary&);
  double root_mean_square(const SegmentValues&) const;
  void accept(CoupledState<dim>&, const NodeVectors<dim>& force);

  Fluid& fluid_;
  const Flag<dim>& flag_;
  const OGrid& grid_;
  CouplingSettings settings_;
  AddedMass<dim> added_mass_;
  WallFriction friction_;
  FlagNewton<dim> newton_;
  FlagEquation<dim> equation_;
  Anderson acceleration_;
  NodeVectors<dim> outer_force_;
  int stations_, segments_;
  SegmentValues weights_;  // root of a segment's share of the flag
  // Of a step.
  WallShape wall_;
  NodeVectors<dim> velocity_, areas_;  // extrapolated; of the segments
  NodeVectors<dim> fixed_;             // forces that the passes do not change
  NodeVectors<dim> x_, v_, a_;         // at its end, of the last pass
  SegmentValues g_, found_, change_;   // the reduced jump, the fluid's [p], change of g by a pass
  std::vector<double> face_velocity_, wall_pressure_, here_, gathered_;
};

/// The same positions with the stretch of the boundary layer's friction (4.1): T(y) = 1.3 Re^-1/2
/// (1 - y^1/2) over K_S for each chordwise segment.
template <int dim>
NodeVectors<dim> stretched_by_friction(const FlagMesh&, const NodeVectors<dim>& x, double K_S,
                                       double Re);

}  // namespace pennon::dns

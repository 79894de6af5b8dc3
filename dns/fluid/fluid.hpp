/// The incompressible Navier-Stokes equations (2.4), (2.5) about the flag, on the grid that moves
/// with it, by (3.2):
///
///   D_t v + ((v - v_g) . grad) v = - grad p + 1/Re lap v,     div v = 0,
///
/// D_t the backward difference at fixed grid coordinates, v_g the grid's velocity by the same
/// difference. Velocity and pressure are kept at cell centres; div v = 0 holds for the fluxes
/// through the faces. docs/theory/fluid.md derives the discrete equations. A step is begin_step(),
/// solve_pressure(), finish_step() in fluid.cpp; its parts are moving_grid, prediction and
/// projection.
///
/// Scales: L, V, rho_f. Order 2 in space and time.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/moving_grid.hpp"
#include "dns/fluid/parameters.hpp"
#include "dns/fluid/prediction.hpp"
#include "dns/fluid/projection.hpp"
#include "dns/fluid/state.hpp"
#include "dns/fluid/step.hpp"
#include "dns/grid/span.hpp"
#include "dns/numerics/krylov.hpp"

namespace pennon::dns {

using WallMotion = std::function<void(double t, WallShape&)>;

class Fluid {
 public:
  /// `span`: one plane for two dimensions, which carries a third velocity only if U is not zero.
  Fluid(const OGrid&, Span, const FluidParameters&, const FluidTolerances&,
        const Upwinding& = upwinding::kawamura_kuwahara);
  ~Fluid() = default;
  Fluid(const Fluid&) = delete;
  Fluid& operator=(const Fluid&) = delete;

  const OGrid& grid() const { return grid_; }
  const Span& span() const { return span_; }
  const FluidParameters& parameters() const { return parameters_; }
  const FluidTolerances& tolerances() const { return tolerances_; }
  const Extent& extent() const { return extent_; }
  int components() const { return components_; }
  const Metrics<double>& metrics() const { return moving_.metrics(); }

  /// The uniform stream about the flag where `wall` has it at t, made free of divergence: an
  /// impulsive start.
  FluidState impulsive_start(const WallMotion& wall, double t);

  /// Advances by dt with a wall that moves as prescribed. Throws SolverError with the time, and the
  /// place where it has one, if the grid folds, a solver does not converge or the velocity is not
  /// finite.
  FluidStepSummary advance(FluidState&, const WallMotion& wall, double dt);

  /// The same in three parts, for a wall whose velocity answers the pressure.
  ///
  /// begin_step() moves the grid to the wall's shape at the end of the step and predicts the
  /// velocity; the wall's velocity is then that of the shape. set_wall_velocity() and
  /// solve_pressure() follow, as often as the wall needs: state.p is then the pressure at the end
  /// of the step, with a root mean square error below `tolerance`. Returns the solver's iterations:
  /// none if it already was. finish_step() leaves what advance() does.
  void begin_step(FluidState&, const WallShape&, double dt);
  int solve_pressure(FluidState&, double tolerance);
  FluidStepSummary finish_step(FluidState&);
  /// The velocity without the new pressure, between begin_step() and the first solve_pressure().
  const std::vector<Field<double>>& predicted_velocity() const { return velocity_; }
  /// Sets a component of the velocity of the wall's faces, at their middle: n_theta numbers for
  /// each plane of this rank.
  void set_wall_velocity(std::size_t component, std::span<const double> velocity);

  /// Adds a body force or sets the wall's velocity, for manufactured solutions.
  void manufacture(Manufactured terms) { manufactured_ = std::move(terms); }

  /// The centre of a cell, (y, z).
  std::array<double, 2> centre(const FluidState&, int plane, int j, int i) const;

  /// The grid velocity and the wall's, of the last step.
  const Field<double>& grid_velocity_y() const { return moving_.velocity_y(); }
  const Field<double>& grid_velocity_z() const { return moving_.velocity_z(); }
  const WallVelocity& wall_velocity() const { return wall_velocity_; }
  /// Fluxes area . u through the faces, free of divergence; from the end of a step to the next.
  const Field<double>& flux_across_rho() const { return projection_.flux_across_rho(); }
  const Field<double>& flux_across_theta() const { return projection_.flux_across_theta(); }

  /// The stream's velocity at the end of the step that is or was last taken.
  double stream(std::size_t component) const { return step_.stream[component]; }
  /// Fills the ghosts of a velocity component for its gradient: at the flag the flag's velocity, no
  /// gradient through the outer boundary.
  void extend_velocity(std::size_t component, Field<double>& f) const;
  /// Fills the ghosts of the pressure.
  void extend_pressure(Field<double>& p) const { projection_.extend_pressure(p); }
  /// At the outer faces, n_theta numbers for each plane, at the end of the last step.
  const std::vector<double>& outer_pressure() const { return projection_.outer_pressure(); }

 private:
  void set_step(double t, double dt, const FluidState&);
  void find_wall_velocity(const FluidState&);

  OGrid grid_;
  Span span_;
  FluidParameters parameters_;
  FluidTolerances tolerances_;
  Extent extent_;
  int components_;
  Manufactured manufactured_;
  FluidScratch scratch_;
  MovingGrid moving_;
  std::shared_ptr<KrylovSpace> krylov_space_;  // no solver runs within another
  Prediction prediction_;
  Projection projection_;

  FluidStep step_;            // that is or was last taken
  FluidStepSummary summary_;  // of it
  bool is_start_ = false;     // from the uniform stream: there is no pressure yet
  WallShape wall_;            // of advance()
  WallVelocity wall_velocity_;
  std::vector<Field<double>> velocity_;  // predicted, then with the last pressure's gradient
};

}  // namespace pennon::dns

/// The incompressible Navier-Stokes equations (2.4), (2.5) about the flag, on the grid that moves
/// with it, by (3.2):
///
///   D_t v + ((v - v_g) . grad) v = - grad p + 1/Re lap v,     div v = 0,
///
/// D_t the backward difference at fixed grid coordinates, v_g the grid's velocity by the same
/// difference. Velocities and pressure at cell centres, div v = 0 for the fluxes through the faces.
/// docs/theory/fluid.md derives the discrete equations.
///
/// Scales: L, V, rho_f. Order 2 in space and time.
#pragma once

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "dns/fluid/equations/stencils.hpp"
#include "dns/fluid/flat_pressure.hpp"
#include "dns/fluid/parameters.hpp"
#include "dns/fluid/velocity_lines.hpp"
#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"
#include "dns/grid/o_grid.hpp"
#include "dns/grid/span.hpp"
#include "dns/numerics/backward_difference.hpp"
#include "dns/numerics/krylov.hpp"

namespace pennon::dns {

/// Where FluidState::u keeps the velocity along x, y, z.
inline constexpr std::array<std::size_t, 3> component_of = {2, 0, 1};

/// Where the wall is: the displacement of the flag from rest at the corners of the grid, for each
/// plane n_theta numbers (Displacement's row 0).
struct WallShape {
  std::vector<double> y, z;
};
using WallMotion = std::function<void(double t, WallShape&)>;

/// A body force and wall velocities given by place and time, along x, y, z, for manufactured
/// solutions; what is empty is not there. Without wall_velocity the wall moves as its shape does.
struct Manufactured {
  using Function = std::function<std::array<double, 3>(double t, double x, double y, double z)>;
  Function force, wall_velocity;
};

/// What is advanced, saved and restarted.
struct FluidState {
  double t = 0;
  double previous_dt = 0;               ///< 0: the next step is the first
  std::vector<Field<double>> u;         ///< velocity: y, z and, where the case has it, x
  std::vector<Field<double>> u_last;    ///< one step before
  std::vector<Field<double>> u_change;  ///< what the last prediction added to its extrapolation:
                                        ///< the next solver's guess
  Field<double> p, p_last;
  std::vector<Displacement<double>> grid;  ///< now, one and two steps before
  std::vector<bool> is_inflow;             ///< of the outer faces, plane by plane
};

/// Wall seconds of a step by phase.
struct FluidStepTimes {
  double grid = 0, metrics = 0, prediction = 0, projection = 0;
};

struct FluidStepSummary {
  int pressure_iterations = 0;
  int velocity_iterations = 0;   ///< the more of (v, w) and u
  int grid_passes = 0;           ///< the most of a plane
  double least_area = 1;         ///< of a cell, over its area at rest
  double largest_wall_area = 1;  ///< of a cell at the flag, over its area at rest
  double CFL = 0;                ///< largest Courant number, sum over the directions
  FluidStepTimes seconds;
};

class Fluid {
 public:
  /// `span`: one plane for two dimensions, which carries a third velocity only if U is not zero.
  Fluid(const OGrid&, Span, const FluidParameters&, const FluidTolerances&,
        const Upwinding& = upwinding::kawamura_kuwahara);

  const OGrid& grid() const { return grid_; }
  const Span& span() const { return span_; }
  const FluidParameters& parameters() const { return parameters_; }
  const FluidTolerances& tolerances() const { return tolerances_; }
  const Extent& extent() const { return extent_; }
  int components() const { return components_; }
  const Metrics<double>& metrics() const { return metrics_; }

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
  const std::vector<Field<double>>& predicted_velocity() const { return guess_; }
  /// Components as in FluidState::u, n_theta numbers for each plane, at the middle of the faces.
  void set_wall_velocity(std::size_t component, std::span<const double> velocity);

  void manufacture(Manufactured terms) { manufactured_ = std::move(terms); }

  /// The centre of a cell, (y, z).
  std::array<double, 2> centre(const FluidState&, int plane, int j, int i) const;

  /// The grid velocity and the wall's, of the last step.
  const Field<double>& grid_velocity_y() const { return grid_velocity_y_; }
  const Field<double>& grid_velocity_z() const { return grid_velocity_z_; }
  /// Components as in FluidState::u, n_theta numbers for each plane.
  const std::vector<std::vector<double>>& wall_velocity() const { return wall_velocity_; }
  /// Fluxes area . u through the faces, free of divergence; from the end of a step to the next.
  const Field<double>& flux_across_rho() const { return flux_rho_; }
  const Field<double>& flux_across_theta() const { return flux_theta_; }

  /// The stream's velocity at the end of the step that is or was last taken.
  double stream(int component) const;
  /// Fills the ghosts of a velocity component for convection, or (is_viscous) for the gradient's
  /// flux: at the flag its velocity, outside as dns/fluid/equations/ghosts.hpp has it. For
  /// convection it is one of the step's own fields.
  void extend_velocity(const FluidState&, int component, Field<double>& f, bool is_viscous) const;
  void extend_pressure(Field<double>& p) const;
  /// At the outer faces, n_theta numbers for each plane, at the end of the last step.
  const std::vector<double>& outer_pressure() const { return outer_pressure_; }

 private:
  struct Components {  // of FluidState::u, first to end - 1
    std::size_t first, end;
  };
  // Between begin_step() and finish_step().
  struct Step {
    BackwardDifference D{1, 0};
    double t = 0, dt = 1;       // at its end, and its length
    double rise_of_stream = 0;  // d/dt of its share of V, by D
    bool is_posed = false;
    bool is_start = false;  // from the uniform stream: there is no pressure yet
    FluidStepSummary summary;
  };
  double risen_stream(int component) const;  // once it has risen
  void move_grid(FluidState&, const WallShape&);
  void find_grid_velocity(const FluidState&);
  void predict(FluidState&);
  void find_convection();
  void subtract_equation(const FluidState&, std::size_t component, double* right);
  void add_force(const FluidState&, std::size_t component, double* right);
  bool has_pressure_gradient(std::size_t component) const;
  void find_pressure_gradient(const FluidState&, std::size_t component, Field<double>& gradient);
  void pose_projection(FluidState&);
  void impose_wall_flux();
  void balance_plane(int plane, const Field<double>& f, Field<double>* f_xi, bool with_wall_flux);
  void carry_plane(int plane, const Field<double>& f, const Field<double>* f_xi);
  void carry_along_span();
  void add_x_flux(double factor, Field<double>& x_flux, double* packed);
  void pressure_operator(const double* in, double* out);
  void invert_flat_pressure(const double* in, double* out);
  void velocity_operator(const Components&, const double* in, double* out);
  void extend_change_outward(int plane, std::size_t component, bool is_viscous,
                             Field<double>&) const;
  void extend_inflow(int plane, const std::vector<bool>& is_inflow,
                     const std::vector<Field<double>>& u, bool with_stream, int component,
                     Field<double>& f) const;
  void find_outer_pressure(const std::vector<Field<double>>& u);
  void subtract_outer_gradient(double dt, Field<double>& scratch);
  void extend_pressure(Field<double>& p, double share) const;
  void update_all_metrics(const Displacement<double>&);
  [[noreturn]] void fail(double t, const std::string& what) const;

  OGrid grid_;
  Span span_;
  FluidParameters parameters_;
  FluidTolerances tolerances_;
  Upwinding upwinding_;
  Extent extent_;
  int components_;
  EllipticGrid elliptic_;
  Metrics<double> metrics_;
  std::map<int, FlatPressure> flat_;           // by the number of waves along the span
  std::shared_ptr<KrylovSpace> krylov_space_;  // no solver runs within another
  Krylov pressure_, velocity_in_plane_, velocity_along_span_;

  Manufactured manufactured_;
  Step step_;
  bool change_varies_ = false;  // whether the velocity's operator has terms along the span
  std::vector<bool> is_inflow_;
  std::vector<double> outer_pressure_;
  WallShape wall_;
  std::vector<std::vector<double>> wall_velocity_;
  std::vector<double> no_velocity_;
  Field<double> grid_velocity_y_, grid_velocity_z_;
  Field<double> flux_rho_, flux_theta_;
  Field<double> balance_, carried_;                // of one plane
  std::vector<Field<double>> change_, change_xi_;  // of two components; and to work in
  Field<double>&C_s_, &C_t_;  // what carries the velocity while it is predicted, in cells along s
                              // and t: in the places of the fluxes, which come after it
  std::vector<Field<double>> guess_;
  VelocityLines lines_;
  std::vector<double> right_, solution_;  // packed: the components one behind the other
};

}  // namespace pennon::dns

/// The second half of a step of the fluid: the new pressure p, which makes the velocity free of
/// divergence,
///
///   v = v* + dt' grad p^n - dt' grad p,     div v = 0 for the fluxes through the faces,
///
/// dt' = 2/3 dt in equal steps. The gradient of p is taken at the faces, that of p^n at the cells
/// and averaged to the faces.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "dns/fluid/flat_pressure.hpp"
#include "dns/fluid/moving_grid.hpp"
#include "dns/fluid/state.hpp"
#include "dns/fluid/step.hpp"
#include "dns/grid/span.hpp"
#include "dns/numerics/krylov.hpp"

namespace pennon::dns {

class Projection {
 public:
  Projection(const OGrid&, const Span&, const MovingGrid&, FluidScratch&,
             const std::shared_ptr<KrylovSpace>&);

  /// Begins a step: the fluxes of the last one, which are kept between steps, are no longer there.
  void begin();
  bool is_posed() const { return is_posed_; }

  /// Poses the problem from the predicted velocity, to which it adds dt' grad p^n (with the ghosts
  /// that state.p has), without any flux through the flag yet. `is_start`: there is no pressure to
  /// begin with. state.p_last becomes p^n.
  void pose(const FluidStep&, bool is_start, FluidState&, std::vector<Field<double>>& velocity);

  /// The flux through the flag's faces, in place of what was imposed before.
  void impose_wall_velocity(const FluidStep&, const WallVelocity&);

  /// p, to a root mean square error below `tolerance`, from what the last solution left.
  KrylovSummary solve(double tolerance, Field<double>& p);

  /// Takes the gradient of state.p from the fluxes and from `velocity`, which becomes state.u;
  /// finds where fluid enters. p is then given its ghosts.
  void finish(const FluidStep&, const std::vector<Field<double>>& velocity, FluidState&);

  /// At the outer faces, n_theta numbers for each plane: p = -u_n v'_n where fluid enters, 0 where
  /// it leaves, of this velocity at the cells.
  void find_outer_pressure(const FluidStep&, const std::vector<Field<double>>& u);
  const std::vector<double>& outer_pressure() const { return outer_pressure_; }
  /// Fills the ghosts of the pressure, with `share` of that of the outer faces.
  void extend_pressure(Field<double>& p, double share = 1) const;

  /// area . u through the faces, free of divergence; from the end of a step to the next.
  const Field<double>& flux_across_rho() const { return *flux_rho_; }
  const Field<double>& flux_across_theta() const { return *flux_theta_; }

 private:
  void find_fluxes(const std::vector<Field<double>>& velocity);
  void subtract_outer_gradient(double dt_of_pressure, Field<double>* flux_x);
  void multiply(const double* in, double* out);
  void invert_flat(const double* in, double* out);

  const Span& span_;
  const MovingGrid& moving_;
  Extent extent_;
  FluidScratch& scratch_;
  std::map<int, FlatPressure> flat_;  // by the number of waves along the span
  Krylov krylov_;
  std::vector<double> outer_pressure_;
  bool is_posed_ = false;
  FieldLease flux_rho_, flux_theta_;
  VectorLease right_side_, solution_;  // packed, from pose() to finish()
};

}  // namespace pennon::dns

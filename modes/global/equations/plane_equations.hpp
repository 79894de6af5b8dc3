/// The equations of the simulation (dns/fluid/fluid.hpp) in one plane x = const, continuous in
/// time, by the same functions (dns/fluid/equations):
///
///   V dv/dt + R_v - dX_v/dx = 0,     R_p - dX_p/dx = 0,
///
///   R_v = V [(C . grad) v + grad p] - 1/Re (integral of lap v),   C = v - v_g,
///   R_p = sum of the fluxes area . (v + tau grad p) - tau area . grad p out of the cell,
///   X_v = V/Re dv/dx,   X_p = -V u,
///
/// V the cells' volumes, tau = 2/3 dt the length with which the steps of the simulation leave the
/// pressure in the fluxes. docs/theory/global-modes.md derives that a state at which a step changes
/// nothing satisfies these equations, and that what grows or decays does so up to dt^2.
///
/// Derivatives by x come in as those of the fields, q_xi. Terms of second order in them are left
/// out: the equations are linearised about what does not depend on x.
///
/// Templated on the scalar, for complex steps. Scales: L, V, rho_f.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/equations/stencils.hpp"
#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"
#include "dns/grid/o_grid.hpp"

namespace pennon::modes::global {

using dns::Displacement;
using dns::Extent;
using dns::Field;
using dns::OGrid;

struct PlaneParameters {
  double Re = 1000;
  double U = 0;    ///< cross-flow, over V
  double tau = 0;  ///< 2/3 of the simulation's time step
  dns::Upwinding upwinding = dns::upwinding::kawamura_kuwahara;
};

/// The flow in a plane: velocity along y, z and, with a span, x; pressure.
template <class Scalar>
struct PlaneFlow {
  std::vector<Field<Scalar>> u;
  Field<Scalar> p;

  PlaneFlow(const Extent& extent, int components, Scalar value = Scalar(0))
      : u(static_cast<std::size_t>(components), Field<Scalar>(extent, value)), p(extent, value) {}
  int components() const { return static_cast<int>(u.size()); }
  /// v, w, u as the case has them, then p.
  int fields() const { return components() + 1; }
  Field<Scalar>& field(int f) { return f < components() ? u[static_cast<std::size_t>(f)] : p; }
  const Field<Scalar>& field(int f) const {
    return f < components() ? u[static_cast<std::size_t>(f)] : p;
  }
};

/// The force of the fluid on each segment of the flag from the leading edge, along x (0 without a
/// span), y and z; per unit span.
template <class Scalar>
struct SegmentForces {
  std::vector<Scalar> x, y, z;
};

template <class Scalar>
class PlaneEquations {
 public:
  /// `components` of the velocity: 2, or 3 with a span or a cross-flow.
  PlaneEquations(const OGrid&, const PlaneParameters&, int components);

  const Extent& extent() const { return extent_; }
  const dns::Metrics<Scalar>& metrics() const { return metrics_; }

  /// Of the corners. `slope`: the displacement's derivative by x, null for none.
  void set_grid(const Displacement<Scalar>& displacement, const Displacement<Scalar>* slope);
  /// The corners' velocity; the wall moves with its own.
  void set_grid_velocity(const Displacement<Scalar>& velocity);
  /// Of the n_theta outer faces.
  void set_inflow(std::vector<bool> is_inflow) { is_inflow_ = std::move(is_inflow); }

  /// R and, if asked for, X; writes the ghosts of q. `q_xi` null: nothing depends on x.
  void evaluate(PlaneFlow<Scalar>& q, const PlaneFlow<Scalar>* q_xi, PlaneFlow<Scalar>& R,
                PlaneFlow<Scalar>* X);

  /// Of the last evaluation. The pressure acts by the difference of the two sides on the upper
  /// face's area, as the simulation's coupling has it.
  const SegmentForces<Scalar>& forces() const { return forces_; }
  /// Through the outer faces; fluid enters where they are negative.
  const Scalar* outer_flux() const { return flux_rho_.row(0, extent_.n_rho); }

 private:
  void momentum(std::size_t component, PlaneFlow<Scalar>& q, const Field<Scalar>* f_xi,
                Field<Scalar>& R);
  void continuity(const PlaneFlow<Scalar>& q, Field<Scalar>& R);
  void find_forces(const PlaneFlow<Scalar>& q);
  bool has_span() const { return metrics_.has_span; }

  OGrid grid_;
  PlaneParameters parameters_;
  std::array<double, 3> stream_;  // by component
  Extent extent_;
  dns::Metrics<Scalar> metrics_;
  Displacement<Scalar> no_slope_;
  std::vector<bool> is_inflow_;
  Field<Scalar> grid_velocity_y_, grid_velocity_z_;
  std::vector<std::vector<Scalar>> wall_velocity_;  // by component
  std::vector<Scalar> outer_pressure_, wall_pressure_;
  Field<Scalar> C_s_, C_t_, convected_, laplacian_, flux_rho_, flux_theta_, across_rho_,
      across_theta_;
  std::vector<Field<Scalar>> gradient_;        // of the pressure, then v + tau grad p
  std::vector<std::vector<Scalar>> friction_;  // of the wall's faces, by component
  SegmentForces<Scalar> forces_;
};

extern template class PlaneEquations<double>;
extern template class PlaneEquations<std::complex<double>>;

}  // namespace pennon::modes::global

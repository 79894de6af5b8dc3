/// The equations of the simulation (dns/fluid/fluid.hpp) in one plane x = const, continuous in
/// time, by the same functions (dns/fluid/equations):
///
///   vol dv/dt + R_v - dX_v/dx = 0,     R_p - dX_p/dx = 0,
///
///   R_v = vol [(C . grad) v + grad p] - 1/Re (integral of lap v),   C = v - v_g,
///   R_p = sum of the fluxes area . (v + dt' grad p) - dt' area . grad p out of the cell,
///   X_v = vol/Re dv/dx,   X_p = -vol u,
///
/// vol the cells' volumes per unit of x, v the velocity vector and u its component along x, dt' =
/// 2/3 dt the weight with which the steps of the simulation leave the pressure's gradient in the
/// fluxes (FluidStep::dt_of_pressure()). docs/theory/global-modes.md derives that a state at which
/// a step changes nothing satisfies these equations, and that a disturbance of it grows in the
/// simulation as they say up to O(dt^2).
///
/// How the flow varies along x is given by the derivatives of its fields, q_xi. Products of two
/// such derivatives are left out, since the equations are linearised about a flow that does not
/// depend on x.
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
  double U = 0;               ///< cross-flow, over V
  double dt_of_pressure = 0;  ///< dt', 2/3 of the simulation's time step, in L/V
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

  /// Sets the displacement of the grid's corners; `slope` is its derivative by x, null for none.
  void set_grid(const Displacement<Scalar>& displacement, const Displacement<Scalar>* slope);
  /// Sets the velocity of the corners, v_g; the wall moves with the corners on it.
  void set_grid_velocity(const Displacement<Scalar>& velocity);
  /// Sets whether fluid enters through each of the n_theta outer faces.
  void set_inflow(std::vector<bool> is_inflow) { is_inflow_ = std::move(is_inflow); }

  /// Finds R and, unless it is null, X at the flow q, whose ghosts it fills. `q_xi`: the derivative
  /// of q by x; null: nothing depends on x.
  void evaluate(PlaneFlow<Scalar>& q, const PlaneFlow<Scalar>* q_xi, PlaneFlow<Scalar>& R,
                PlaneFlow<Scalar>* X);

  /// The forces at the flow of the last evaluation. As in the simulation's coupling, the pressure
  /// below less that above acts on the area of the upper face.
  const SegmentForces<Scalar>& forces() const { return forces_; }
  /// The n_theta fluxes through the outer faces, negative where fluid enters.
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
  std::vector<Field<Scalar>> gradient_;        // of the pressure, then v + dt' grad p
  std::vector<std::vector<Scalar>> friction_;  // of the wall's faces, by component
  SegmentForces<Scalar> forces_;
};

extern template class PlaneEquations<double>;
extern template class PlaneEquations<std::complex<double>>;

}  // namespace pennon::modes::global

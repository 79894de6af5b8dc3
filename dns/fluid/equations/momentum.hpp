/// The momentum equation (3.2) of one component f of the velocity on a plane, integrated over the
/// cells:
///
///   R = vol [rate + (C . grad) f + (grad p)_f] - 1/Re (integral of lap f),     C = v - v_g,
///
/// vol the cells' volumes per unit of x, `rate` the time derivative, (grad p)_f the component of
/// grad p along that of f. The part along x of the friction's divergence, d/dx (vol/Re df/dx), is
/// left to the caller, who knows how the fields vary along x.
///
/// Written once for any scalar: the step of the simulation, the steady flow and the linearised
/// operator (complex steps) evaluate these functions.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/equations/stencils.hpp"
#include "dns/grid/o_grid.hpp"

namespace pennon::dns {

/// What the outer boundary does to a velocity.
template <class Scalar>
struct OuterBoundary {
  const FaceMetrics<Scalar>& rho_faces;
  /// The ratio in which lines theta = const part from the last cells to the near ghosts.
  double widening;
  const std::vector<bool>& is_inflow;  ///< of the outer faces, plane by plane
  std::array<double, 3> stream;        ///< by component; zero for a change of the velocity
};

/// OuterBoundary::widening of the grid at rest, where y + i z goes as cosh(rho + i theta).
inline double outer_widening(const OGrid& grid) {
  return std::exp(grid.rho_face_step(grid.n_rho()));
}

/// Fills the outer ghosts of a component f for convection, in whose boundary condition the velocity
/// (v, w) in the plane takes part. Precondition: f has its values at the cells.
template <class Scalar>
void extend_outward_for_convection(int plane, const OuterBoundary<Scalar>& boundary,
                                   const Field<Scalar>& v, const Field<Scalar>& w,
                                   std::size_t component, Field<Scalar>& f) {
  extend_outward(plane, false, f);
  const Inflow<Scalar> inflow{boundary.is_inflow,      boundary.rho_faces, boundary.widening, v, w,
                              boundary.stream[along_y]};
  const Field<Scalar>* area =
      component == along_x ? nullptr : &area_along(boundary.rho_faces, component);
  reflect_inflow(plane, inflow, area, boundary.stream[component], f);
  f.wrap_theta(plane, f.extent().n_rho, f.extent().n_rho + 2);
}

/// The same for the friction's fluxes: no gradient through the outer boundary.
template <class Scalar>
void extend_outward_for_friction(int plane, Field<Scalar>& f) {
  extend_outward(plane, true, f);
  f.wrap_theta(plane, f.extent().n_rho, f.extent().n_rho + 2);
}

/// Fills the ghosts at the wall and along theta from the velocity of the wall's n_theta faces.
template <class Scalar>
void extend_inward(int plane, const Scalar* wall_velocity, Field<Scalar>& f) {
  extend_to_wall(plane, wall_velocity, f);
  f.wrap_theta(plane, -2, f.extent().n_rho);
}

/// (C . grad) f at the cells of a plane, into the first plane of `result`: C_s and C_t in cells per
/// time, along x the velocity u_x times f_xi (null: nothing varies along x).
template <class Scalar>
void convective_derivative(int plane, const Field<Scalar>& C_s, const Field<Scalar>& C_t,
                           const Field<Scalar>* u_x, const Field<Scalar>& f,
                           const Field<Scalar>* f_xi, const Upwinding& upwinding,
                           Field<Scalar>& result) {
  convection(plane, C_s, C_t, f, upwinding, result);
  if (!f_xi) return;
  for (int j = 0; j < f.extent().n_rho; ++j) {
    const Scalar *u = u_x->row(plane, j), *xi = f_xi->row(plane, j);
    Scalar* sum = result.row(0, j);
    for (int i = 0; i < f.extent().n_theta; ++i) sum[i] += u[i] * xi[i];
  }
}

/// A component of grad p at the cells of a plane, from p with its ghosts; p_xi (null: none) adds to
/// that along x.
template <class Scalar>
void pressure_gradient(const Metrics<Scalar>& metrics, int plane, std::size_t component,
                       const Field<Scalar>& p, const Field<Scalar>* p_xi, Field<Scalar>& gradient) {
  const std::array<const Field<Scalar>*, 3> s = {&metrics.s_y, &metrics.s_z, &metrics.s_x},
                                            t = {&metrics.t_y, &metrics.t_z, &metrics.t_x};
  gradient_component(plane, *s[component], *t[component], p, gradient);
  if (component != along_x || !p_xi) return;
  for (int j = 0; j < p.extent().n_rho; ++j) {
    const Scalar* xi = p_xi->row(plane, j);
    Scalar* sum = gradient.row(plane, j);
    for (int i = 0; i < p.extent().n_theta; ++i) sum[i] += xi[i];
  }
}

/// The terms of R in a row of cells that every caller has. `laplacian`: the integral of lap f.
template <class Scalar>
struct MomentumRow {
  const Scalar *volume, *convected, *laplacian;
};

/// R of a row of n cells; rate(i) and push(i), the pressure's gradient, are those of cell i.
template <class Scalar, class Rate, class Push>
void momentum_residual(int n, const MomentumRow<Scalar>& row, double nu, const Rate& rate,
                       const Push& push, Scalar* R) {
  for (int i = 0; i < n; ++i)
    R[i] = row.volume[i] * (rate(i) + row.convected[i] + push(i)) - nu * row.laplacian[i];
}

/// A term that is not there.
inline constexpr auto no_term = [](int) { return 0.0; };

}  // namespace pennon::dns

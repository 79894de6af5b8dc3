/// The spatial operators of the fluid on a plane of the moving O-grid, of second order but for
/// convection. Fields at cell centres come with their ghosts filled
/// (dns/fluid/equations/ghosts.hpp); what depends on x comes in as derivatives by xi, null where
/// there is no span.
///
/// Integrals over a cell (per unit of x) are given as such: divide by Metrics::volume for the mean.
/// The sum of a divergence over the cells is the flux through the boundary, to rounding.
#pragma once

#include <algorithm>
#include <complex>
#include <utility>

#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"

namespace pennon::dns {

/// How convection is differenced along s and t: fourth-order central differences and an upwind
/// fourth difference with this factor times |C|/12, C the velocity across the cells.
struct Upwinding {
  double factor = 3;
  bool is_central = false;  ///< second-order central differences instead
};
namespace upwinding {
inline constexpr Upwinding kawamura_kuwahara{3, false};  ///< Kawamura & Kuwahara (1984)
inline constexpr Upwinding third_order{1, false};        ///< the least that is third-order upwind
inline constexpr Upwinding central{0, true};
}  // namespace upwinding

/// |C| by the sign of the real part, so that complex steps pass through.
template <class Scalar>
Scalar magnitude(const Scalar& C) {
  return std::real(C) < 0 ? -C : C;
}

/// area . grad f through the n_theta faces across rho of row j; f_xi at the cells, with ghosts.
template <class Scalar>
void gradient_flux_across_rho(const Metrics<Scalar>& metrics, int plane, int j,
                              const Field<Scalar>& f, const Field<Scalar>* f_xi, Scalar* flux) {
  const int n_theta = f.extent().n_theta;
  const Scalar *below = f.row(plane, j - 1), *here = f.row(plane, j);
  const Scalar* along = metrics.rho_faces.along.row(plane, j);
  const Scalar* across = metrics.rho_faces.across.row(plane, j);
  for (int i = 0; i < n_theta; ++i)
    flux[i] = along[i] * (here[i] - below[i]) +
              across[i] * 0.25 * (here[i + 1] - here[i - 1] + below[i + 1] - below[i - 1]);
  if (!f_xi) return;
  const Scalar *xi_below = f_xi->row(plane, j - 1), *xi_here = f_xi->row(plane, j);
  const Scalar* area_x = metrics.rho_faces.area_x.row(plane, j);
  for (int i = 0; i < n_theta; ++i) flux[i] += area_x[i] * 0.5 * (xi_below[i] + xi_here[i]);
}

/// The same through the n_theta + 1 faces across theta of row j.
template <class Scalar>
void gradient_flux_across_theta(const Metrics<Scalar>& metrics, int plane, int j,
                                const Field<Scalar>& f, const Field<Scalar>* f_xi, Scalar* flux) {
  const int n_theta = f.extent().n_theta;
  const Scalar *below = f.row(plane, j - 1), *here = f.row(plane, j), *above = f.row(plane, j + 1);
  const Scalar* along = metrics.theta_faces.along.row(plane, j);
  const Scalar* across = metrics.theta_faces.across.row(plane, j);
  for (int i = 0; i <= n_theta; ++i)
    flux[i] = along[i] * (here[i] - here[i - 1]) +
              across[i] * 0.25 * (above[i] + above[i - 1] - below[i] - below[i - 1]);
  if (!f_xi) return;
  const Scalar *xi = f_xi->row(plane, j), *area_x = metrics.theta_faces.area_x.row(plane, j);
  for (int i = 0; i <= n_theta; ++i) flux[i] += area_x[i] * 0.5 * (xi[i] + xi[i - 1]);
}

/// area . grad f through the faces of a plane: rows 0 .. n_rho across rho, columns 0 .. n_theta
/// across theta.
template <class Scalar>
void gradient_flux(const Metrics<Scalar>& metrics, int plane, const Field<Scalar>& f,
                   const Field<Scalar>* f_xi, Field<Scalar>& across_rho,
                   Field<Scalar>& across_theta) {
  const int n_rho = f.extent().n_rho;
  for (int j = 0; j <= n_rho; ++j)
    gradient_flux_across_rho(metrics, plane, j, f, f_xi, across_rho.row(plane, j));
  for (int j = 0; j < n_rho; ++j)
    gradient_flux_across_theta(metrics, plane, j, f, f_xi, across_theta.row(plane, j));
}

/// Adds the sum of the fluxes out of each cell of a plane, the integral of their divergence, to
/// `sum` (at the cells).
template <class Scalar>
void add_divergence(int plane, const Field<Scalar>& across_rho, const Field<Scalar>& across_theta,
                    Field<Scalar>& sum) {
  const int n_rho = sum.extent().n_rho, n_theta = sum.extent().n_theta;
  for (int j = 0; j < n_rho; ++j) {
    const Scalar *below = across_rho.row(plane, j), *above = across_rho.row(plane, j + 1);
    const Scalar* theta = across_theta.row(plane, j);
    Scalar* out = sum.row(plane, j);
    for (int i = 0; i < n_theta; ++i) out[i] += above[i] - below[i] + theta[i + 1] - theta[i];
  }
}

/// The integral of lap f over each cell of a plane, as the sum of gradient_flux() out of the cell
/// and so without the part along x, into the first plane of `laplacian`. Without the wall's flux
/// nothing passes through the flag. Works in three rows of the ghosts of `laplacian`.
template <class Scalar>
void integrated_laplacian(const Metrics<Scalar>& metrics, int plane, const Field<Scalar>& f,
                          const Field<Scalar>* f_xi, bool with_wall_flux,
                          Field<Scalar>& laplacian) {
  const int n_rho = f.extent().n_rho, n_theta = f.extent().n_theta;
  Scalar *inward = laplacian.row(0, n_rho), *outward = laplacian.row(0, -1);
  Scalar* theta = laplacian.row(0, -2);
  if (with_wall_flux)
    gradient_flux_across_rho(metrics, plane, 0, f, f_xi, inward);
  else
    std::fill_n(inward, n_theta, Scalar(0));
  for (int j = 0; j < n_rho; ++j) {
    gradient_flux_across_rho(metrics, plane, j + 1, f, f_xi, outward);
    gradient_flux_across_theta(metrics, plane, j, f, f_xi, theta);
    Scalar* out = laplacian.row(0, j);
    for (int i = 0; i < n_theta; ++i) out[i] = outward[i] - inward[i] + theta[i + 1] - theta[i];
    std::swap(inward, outward);
  }
}

/// volume times df/dx at the cells of a plane, over the derivative by xi.
template <class Scalar>
void gradient_flux_along_x(const Metrics<Scalar>& metrics, int plane, const Field<Scalar>& f,
                           Field<Scalar>& f_xi) {
  for (int j = 0; j < f.extent().n_rho; ++j) {
    const Scalar *below = f.row(plane, j - 1), *here = f.row(plane, j),
                 *above = f.row(plane, j + 1);
    const Scalar *s_x = metrics.s_x.row(plane, j), *t_x = metrics.t_x.row(plane, j);
    const Scalar* volume = metrics.volume.row(plane, j);
    Scalar* flux = f_xi.row(plane, j);
    for (int i = 0; i < f.extent().n_theta; ++i)
      flux[i] = volume[i] * (flux[i] + s_x[i] * 0.5 * (above[i] - below[i]) +
                             t_x[i] * 0.5 * (here[i + 1] - here[i - 1]));
  }
}

/// The components of grad f at the cells of a plane. x null: no span.
template <class Scalar>
struct GradientView {
  Field<Scalar>*x, *y, *z;
};

template <class Scalar>
void gradient(const Metrics<Scalar>& metrics, int plane, const Field<Scalar>& f,
              const Field<Scalar>* f_xi, const GradientView<Scalar>& result) {
  const int n_rho = f.extent().n_rho, n_theta = f.extent().n_theta;
  for (int j = 0; j < n_rho; ++j) {
    const Scalar *below = f.row(plane, j - 1), *here = f.row(plane, j),
                 *above = f.row(plane, j + 1);
    const Scalar *s_y = metrics.s_y.row(plane, j), *s_z = metrics.s_z.row(plane, j);
    const Scalar *t_y = metrics.t_y.row(plane, j), *t_z = metrics.t_z.row(plane, j);
    Scalar *y = result.y->row(plane, j), *z = result.z->row(plane, j);
    for (int i = 0; i < n_theta; ++i) {
      const Scalar f_s = 0.5 * (above[i] - below[i]), f_t = 0.5 * (here[i + 1] - here[i - 1]);
      y[i] = s_y[i] * f_s + t_y[i] * f_t;
      z[i] = s_z[i] * f_s + t_z[i] * f_t;
    }
    if (result.x) {
      const Scalar *s_x = metrics.s_x.row(plane, j), *t_x = metrics.t_x.row(plane, j);
      const Scalar* xi = f_xi->row(plane, j);
      Scalar* x = result.x->row(plane, j);
      for (int i = 0; i < n_theta; ++i)
        x[i] = xi[i] + s_x[i] * 0.5 * (above[i] - below[i]) +
               t_x[i] * 0.5 * (here[i + 1] - here[i - 1]);
    }
  }
}

/// One component of grad f at the cells of a plane, from that of grad s and grad t: along y and z
/// as gradient() gives it, along x without f_xi.
template <class Scalar>
void gradient_component(int plane, const Field<Scalar>& grad_s, const Field<Scalar>& grad_t,
                        const Field<Scalar>& f, Field<Scalar>& result) {
  for (int j = 0; j < f.extent().n_rho; ++j) {
    const Scalar *below = f.row(plane, j - 1), *here = f.row(plane, j),
                 *above = f.row(plane, j + 1);
    const Scalar *s = grad_s.row(plane, j), *t = grad_t.row(plane, j);
    Scalar* out = result.row(plane, j);
    for (int i = 0; i < f.extent().n_theta; ++i)
      out[i] = s[i] * (0.5 * (above[i] - below[i])) + t[i] * (0.5 * (here[i + 1] - here[i - 1]));
  }
}

/// What carries the velocity, v - v_g, in cells along s and t per time, at row j. u_x null: no
/// span.
template <class Scalar>
void convecting_velocity(const Metrics<Scalar>& metrics, int plane, int j, const Field<Scalar>* u_x,
                         const Field<Scalar>& u_y, const Field<Scalar>& u_z,
                         const Field<Scalar>& grid_velocity_y, const Field<Scalar>& grid_velocity_z,
                         Scalar* C_s, Scalar* C_t) {
  const int n_theta = u_y.extent().n_theta;
  const Scalar *v = u_y.row(plane, j), *w = u_z.row(plane, j);
  const Scalar *v_g = grid_velocity_y.row(plane, j), *w_g = grid_velocity_z.row(plane, j);
  const Scalar *s_y = metrics.s_y.row(plane, j), *s_z = metrics.s_z.row(plane, j);
  const Scalar *t_y = metrics.t_y.row(plane, j), *t_z = metrics.t_z.row(plane, j);
  for (int i = 0; i < n_theta; ++i) {
    C_s[i] = (v[i] - v_g[i]) * s_y[i] + (w[i] - w_g[i]) * s_z[i];
    C_t[i] = (v[i] - v_g[i]) * t_y[i] + (w[i] - w_g[i]) * t_z[i];
  }
  if (!u_x) return;
  const Scalar* u = u_x->row(plane, j);
  const Scalar *s_x = metrics.s_x.row(plane, j), *t_x = metrics.t_x.row(plane, j);
  for (int i = 0; i < n_theta; ++i) {
    C_s[i] += u[i] * s_x[i];
    C_t[i] += u[i] * t_x[i];
  }
}

/// C_s f_s + C_t f_t at the cells of a plane: f carried by the velocity (C_s, C_t) in cells per
/// time, into the first plane of `result`.
template <class Scalar>
void convection(int plane, const Field<Scalar>& C_s, const Field<Scalar>& C_t,
                const Field<Scalar>& f, const Upwinding& upwinding, Field<Scalar>& result) {
  const int n_rho = f.extent().n_rho, n_theta = f.extent().n_theta;
  // Weights of the differences over two and four cells, and of the fourth difference.
  const double near = upwinding.is_central ? 0.5 : 8.0 / 12;
  const double far = upwinding.is_central ? 0.0 : -1.0 / 12;
  const double fourth = upwinding.is_central ? 0.0 : upwinding.factor / 12;
  for (int j = 0; j < n_rho; ++j) {
    const Scalar *f0 = f.row(plane, j - 2), *f1 = f.row(plane, j - 1), *f2 = f.row(plane, j),
                 *f3 = f.row(plane, j + 1), *f4 = f.row(plane, j + 2);
    const Scalar *s = C_s.row(plane, j), *t = C_t.row(plane, j);
    Scalar* out = result.row(0, j);
    for (int i = 0; i < n_theta; ++i) {
      const Scalar centre = 6.0 * f2[i];
      out[i] = s[i] * (near * (f3[i] - f1[i]) + far * (f4[i] - f0[i])) +
               magnitude(s[i]) * fourth * (f0[i] - 4.0 * (f1[i] + f3[i]) + centre + f4[i]) +
               t[i] * (near * (f2[i + 1] - f2[i - 1]) + far * (f2[i + 2] - f2[i - 2])) +
               magnitude(t[i]) * fourth *
                   (f2[i - 2] - 4.0 * (f2[i - 1] + f2[i + 1]) + centre + f2[i + 2]);
    }
  }
}

/// area . u through the faces of a plane, from the velocity at the cells with ghosts: rows
/// 1 .. n_rho - 1 across rho (the wall's and the outer ones are the boundary conditions' affair),
/// all columns across theta. u_x null: no span.
template <class Scalar>
void velocity_flux(const Metrics<Scalar>& metrics, int plane, const Field<Scalar>* u_x,
                   const Field<Scalar>& u_y, const Field<Scalar>& u_z, Field<Scalar>& across_rho,
                   Field<Scalar>& across_theta) {
  const int n_rho = u_y.extent().n_rho, n_theta = u_y.extent().n_theta;
  const auto add = [&](const Field<Scalar>& u, const Field<Scalar>& area_rho,
                       const Field<Scalar>& area_theta, bool is_first) {
    for (int j = 1; j < n_rho; ++j) {
      const Scalar *below = u.row(plane, j - 1), *here = u.row(plane, j);
      const Scalar* area = area_rho.row(plane, j);
      Scalar* flux = across_rho.row(plane, j);
      if (is_first)
        for (int i = 0; i < n_theta; ++i) flux[i] = area[i] * 0.5 * (below[i] + here[i]);
      else
        for (int i = 0; i < n_theta; ++i) flux[i] += area[i] * 0.5 * (below[i] + here[i]);
    }
    for (int j = 0; j < n_rho; ++j) {
      const Scalar* here = u.row(plane, j);
      const Scalar* area = area_theta.row(plane, j);
      Scalar* flux = across_theta.row(plane, j);
      if (is_first)
        for (int i = 0; i <= n_theta; ++i) flux[i] = area[i] * 0.5 * (here[i - 1] + here[i]);
      else
        for (int i = 0; i <= n_theta; ++i) flux[i] += area[i] * 0.5 * (here[i - 1] + here[i]);
    }
  };
  add(u_y, metrics.rho_faces.area_y, metrics.theta_faces.area_y, true);
  add(u_z, metrics.rho_faces.area_z, metrics.theta_faces.area_z, false);
  if (metrics.has_span && u_x)
    add(*u_x, metrics.rho_faces.area_x, metrics.theta_faces.area_x, false);
}

}  // namespace pennon::dns

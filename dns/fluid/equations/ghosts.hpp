/// Ghosts of a field at the cells of a plane: the boundary conditions of the stencils.
///
/// At the flag a field is extended as the parabola through its value there and the two nearest
/// cells: the difference across the wall is then the one-sided derivative of second order.
#pragma once

#include <cmath>
#include <complex>
#include <vector>

#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"

namespace pennon::dns {

/// From its values at the wall, n_theta of them at the middle of the faces. Both ghosts.
template <class Scalar>
void extend_to_wall(int plane, const Scalar* wall, Field<Scalar>& f) {
  const Scalar *f0 = f.row(plane, 0), *f1 = f.row(plane, 1);
  Scalar *near = f.row(plane, -1), *far = f.row(plane, -2);
  for (int i = 0; i < f.extent().n_theta; ++i) {
    near[i] = 8.0 / 3 * wall[i] - 2.0 * f0[i] + 1.0 / 3 * f1[i];
    far[i] = 8.0 * wall[i] - 9.0 * f0[i] + 2.0 * f1[i];
  }
}

/// Without a value at the wall, by the line through the two nearest cells: the near ghost. (The
/// parabola through three feeds back on itself at the edges of the flag, where the pressure goes as
/// 1/|rho + i theta|: with cells as long in rho as in theta or longer, it grows from step to step.)
template <class Scalar>
void extrapolate_to_wall(int plane, Field<Scalar>& f) {
  const Scalar *f0 = f.row(plane, 0), *f1 = f.row(plane, 1);
  Scalar* near = f.row(plane, -1);
  for (int i = 0; i < f.extent().n_theta; ++i) near[i] = 2.0 * f0[i] - f1[i];
}

/// The value at the wall of the parabola through the three nearest cells.
template <class Scalar>
Scalar wall_value(const Scalar& f0, const Scalar& f1, const Scalar& f2) {
  return (15.0 * f0 - 10.0 * f1 + 3.0 * f2) / 8.0;
}

/// Behind the outer boundary, both ghosts. For convection the parabola through the last three
/// cells, with which it becomes one-sided, for what leaves. For viscous fluxes no gradient, also
/// where the stream enters.
template <class Scalar>
void extend_outward(int plane, bool is_viscous, Field<Scalar>& f) {
  const int n = f.extent().n_rho;
  const Scalar *f0 = f.row(plane, n - 1), *f1 = f.row(plane, n - 2), *f2 = f.row(plane, n - 3);
  Scalar *near = f.row(plane, n), *far = f.row(plane, n + 1);
  for (int i = 0; i < f.extent().n_theta; ++i) {
    near[i] = is_viscous ? f0[i] : 3.0 * (f0[i] - f1[i]) + f2[i];
    far[i] = is_viscous ? f0[i] : 6.0 * f0[i] - 8.0 * f1[i] + 3.0 * f2[i];
  }
}

/// The value at the outer face of the line through the two nearest cells.
template <class Scalar>
Scalar outside_value(const Scalar& last, const Scalar& before) {
  return 1.5 * last - 0.5 * before;
}

/// p = -u_n v'_n at the n_theta outer faces where fluid enters, 0 where it leaves; v, w along y, z.
template <class Scalar>
void find_outer_pressure(int plane, const FaceMetrics<Scalar>& rho_faces, const Field<Scalar>& v,
                         const Field<Scalar>& w, double stream, Scalar* outer_pressure) {
  const int n_rho = v.extent().n_rho;
  const Scalar *A_y = rho_faces.area_y.row(plane, n_rho), *A_z = rho_faces.area_z.row(plane, n_rho);
  const auto outside = [&](const Field<Scalar>& f, int i) {
    return outside_value(f.row(plane, n_rho - 1)[i], f.row(plane, n_rho - 2)[i]);
  };
  for (int i = 0; i < v.extent().n_theta; ++i) {
    const Scalar flux = A_y[i] * outside(v, i) + A_z[i] * outside(w, i);
    const Scalar inward = std::real(flux) < 0 ? flux : Scalar(0);
    outer_pressure[i] = -inward * (flux - A_y[i] * stream) / (A_y[i] * A_y[i] + A_z[i] * A_z[i]);
  }
}

/// The ghosts of the pressure, with `share` of that of the outer faces.
template <class Scalar>
void extend_pressure(int plane, const Scalar* outer_pressure, double share, Field<Scalar>& p) {
  const int n_rho = p.extent().n_rho;
  extrapolate_to_wall(plane, p);
  const Scalar* last = p.row(plane, n_rho - 1);
  Scalar* ghost = p.row(plane, n_rho);
  for (int i = 0; i < p.extent().n_theta; ++i) ghost[i] = 2 * share * outer_pressure[i] - last[i];
  p.wrap_theta(plane, -1, n_rho + 1);
}

/// What enters through the outer boundary: `velocity` (v, w) less its `stream` along y is normal to
/// the faces there, and widens with the grid, whose lines theta = const part in the ratio
/// `widening` from the last cells to the near ghosts.
template <class Scalar>
struct Inflow {
  const std::vector<bool>& is_inflow;  ///< of the face i of plane m at m n_theta + i
  const FaceMetrics<Scalar>& faces;    ///< across rho
  double widening;
  const Field<Scalar>&v, &w;
  double stream;
};

/// Overwrites, where fluid enters, both ghosts of f for convection: of the component of the
/// velocity whose area component is `area` (null: along the span), and which is `own_stream` in the
/// stream.
template <class Scalar>
void reflect_inflow(int plane, const Inflow<Scalar>& inflow, const Field<Scalar>* area,
                    double own_stream, Field<Scalar>& f) {
  const int n = f.extent().n_rho;
  const Scalar *A_y = inflow.faces.area_y.row(plane, n), *A_z = inflow.faces.area_z.row(plane, n);
  const Scalar* A = area ? area->row(plane, n) : nullptr;
  const std::size_t first = f.extent().wall_face(plane, 0);
  for (int g = 0; g < 2; ++g) {
    const int mirror = n - 1 - g;
    const Scalar *v = inflow.v.row(plane, mirror), *w = inflow.w.row(plane, mirror),
                 *here = f.row(plane, mirror);
    Scalar* ghost = f.row(plane, n + g);
    // Of the normal part, 1 for what the reflection turns round.
    const double normal_share = 1 + 1 / std::pow(inflow.widening, 2 * g + 1);
    for (int i = 0; i < f.extent().n_theta; ++i) {
      if (!inflow.is_inflow[first + static_cast<std::size_t>(i)]) continue;
      ghost[i] = 2.0 * own_stream - here[i];
      if (A)
        ghost[i] += normal_share * A[i] * (A_y[i] * (v[i] - inflow.stream) + A_z[i] * w[i]) /
                    (A_y[i] * A_y[i] + A_z[i] * A_z[i]);
    }
  }
}

}  // namespace pennon::dns

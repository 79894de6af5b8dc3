/// The equation of continuity on a plane, for the fluxes through the faces:
///
///   R = sum of area . (v + dt' grad p) - dt' area . grad p over the faces,
///
/// the first gradient taken at the cells and averaged to the faces, the second one at the faces.
/// The difference of the two couples neighbouring cells; dt' is FluidStep::dt_of_pressure(), the
/// weight with which a step leaves it in the fluxes (docs/theory/fluid.md). The flux through the
/// flag is that of its own motion, the flux through the outer boundary is extrapolated from the
/// last two cells.
///
/// Written once for any scalar: the projection of the simulation, the steady flow and the
/// linearised operator evaluate these functions.
#pragma once

#include <vector>

#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/equations/stencils.hpp"

namespace pennon::dns {

/// area . u through the n_theta faces of a plane's wall; `wall_velocity` by component, n_theta
/// numbers for each plane.
template <class Scalar>
void wall_flux(const Metrics<Scalar>& metrics, int plane,
               const std::vector<std::vector<Scalar>>& wall_velocity, Scalar* flux) {
  const FaceMetrics<Scalar>& faces = metrics.rho_faces;
  const Extent& extent = faces.area_y.extent();
  const std::size_t first = extent.wall_face(plane, 0);
  const Scalar *A_y = faces.area_y.row(plane, 0), *A_z = faces.area_z.row(plane, 0);
  const Scalar *v = wall_velocity[along_y].data() + first,
               *w = wall_velocity[along_z].data() + first;
  for (int i = 0; i < extent.n_theta; ++i) flux[i] = A_y[i] * v[i] + A_z[i] * w[i];
  if (!metrics.has_span) return;
  const Scalar *A_x = faces.area_x.row(plane, 0), *u = wall_velocity[along_x].data() + first;
  for (int i = 0; i < extent.n_theta; ++i) flux[i] += A_x[i] * u[i];
}

/// area . u through the n_theta outer faces, from the velocity at the cells.
template <class Scalar>
void outer_flux(const Metrics<Scalar>& metrics, int plane, const std::vector<Field<Scalar>>& u,
                Scalar* flux) {
  const FaceMetrics<Scalar>& faces = metrics.rho_faces;
  const int n_rho = u[along_y].extent().n_rho, n_theta = u[along_y].extent().n_theta;
  const auto add = [&](std::size_t component, bool is_first) {
    const Scalar *last = u[component].row(plane, n_rho - 1),
                 *before = u[component].row(plane, n_rho - 2);
    const Scalar* A = area_along(faces, component).row(plane, n_rho);
    for (int i = 0; i < n_theta; ++i) {
      const Scalar through = A[i] * outside_value(last[i], before[i]);
      flux[i] = is_first ? through : flux[i] + through;
    }
  };
  add(along_y, true);
  add(along_z, false);
  if (metrics.has_span) add(along_x, false);
}

/// Subtracts dt' times the fluxes of grad p from those of the velocity, but not at the flag,
/// through which the pressure drives no flux.
template <class Scalar>
void subtract_pressure_flux(int plane, double dt_of_pressure, const Field<Scalar>& p_across_rho,
                            const Field<Scalar>& p_across_theta, Field<Scalar>& flux_rho,
                            Field<Scalar>& flux_theta) {
  const int n_rho = flux_rho.extent().n_rho, n_theta = flux_rho.extent().n_theta;
  for (int j = 0; j <= n_rho; ++j) {
    Scalar *rho = flux_rho.row(plane, j), *theta = flux_theta.row(plane, j);
    const Scalar *p_rho = p_across_rho.row(plane, j), *p_theta = p_across_theta.row(plane, j);
    if (j > 0)
      for (int i = 0; i < n_theta; ++i) rho[i] -= dt_of_pressure * p_rho[i];
    if (j < n_rho)
      for (int i = 0; i <= n_theta; ++i) theta[i] -= dt_of_pressure * p_theta[i];
  }
}

}  // namespace pennon::dns

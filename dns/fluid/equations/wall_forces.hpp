/// What the fluid does to the wall's faces and to the segments of the flag between them.
///
/// The traction is -p n + 1/Re (n . grad) v, (2.3) without the part 1/Re (grad v) . n: on a wall
/// that part depends on the wall's velocity alone, and cancels between the flag's two sides.
#pragma once

#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/equations/stencils.hpp"
#include "dns/fluid/equations/wall_faces.hpp"

namespace pennon::dns {

/// 1/Re area . grad f through the n_theta faces of a plane's wall: the friction's force on them,
/// per unit of x, along the component f of the velocity, from f's rows -1 and 0 with their ghosts.
template <class Scalar>
void wall_friction_of(const Metrics<Scalar>& metrics, int plane, double nu, const Field<Scalar>& f,
                      const Field<Scalar>* f_xi, Scalar* force) {
  gradient_flux_across_rho(metrics, plane, 0, f, f_xi, force);
  for (int i = 0; i < f.extent().n_theta; ++i) force[i] *= nu;
}

/// The pressure at the middle of the n_theta faces of a plane's wall.
template <class Scalar>
void wall_pressure_of(int plane, const Field<Scalar>& p, Scalar* pressure) {
  const Scalar *p0 = p.row(plane, 0), *p1 = p.row(plane, 1), *p2 = p.row(plane, 2);
  for (int i = 0; i < p.extent().n_theta; ++i) pressure[i] = wall_value(p0[i], p1[i], p2[i]);
}

/// Of the segment s of the flag in a plane: the sum over its two faces of what acts on each (the
/// friction), and the pressure below less that above, which acts on the upper face's area. `faces`:
/// n_theta numbers of the plane's wall.
template <class Scalar>
Scalar sum_of_sides(int n_theta, int s, const Scalar* faces) {
  return faces[upper_face(n_theta, s)] + faces[lower_face(n_theta, s)];
}
template <class Scalar>
Scalar pressure_jump(int n_theta, int s, const Scalar* faces) {
  return faces[lower_face(n_theta, s)] - faces[upper_face(n_theta, s)];
}

}  // namespace pennon::dns

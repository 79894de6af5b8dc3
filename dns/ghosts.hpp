/// Ghosts of a field at the cells of a plane: the boundary conditions of the stencils.
///
/// At the flag a field is extended as the parabola through its value there and the two nearest
/// cells: the difference across the wall is then the one-sided derivative of second order.
#pragma once

#include <vector>

#include "dns/field.hpp"

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

/// Behind the outer boundary. For convection: where the stream enters, its value; where it leaves,
/// the parabola through the last three cells, with which it becomes one-sided. For viscous fluxes
/// no gradient, also where the stream enters: the last cells hold the stream and what the flag's
/// pressure makes of it, and that difference over one cell would be a force that grows as the grid
/// is refined. `is_inflow` of the face i of this plane stands at first + i. Both ghosts.
template <class Scalar>
void extend_outward(int plane, const std::vector<bool>& is_inflow, std::size_t first,
                    const Scalar& stream, bool is_viscous, Field<Scalar>& f) {
  const int n = f.extent().n_rho;
  const Scalar *f0 = f.row(plane, n - 1), *f1 = f.row(plane, n - 2), *f2 = f.row(plane, n - 3);
  Scalar *near = f.row(plane, n), *far = f.row(plane, n + 1);
  for (int i = 0; i < f.extent().n_theta; ++i) {
    const bool enters = is_inflow[first + static_cast<std::size_t>(i)];
    near[i] = is_viscous ? f0[i] : enters ? stream : 3.0 * (f0[i] - f1[i]) + f2[i];
    far[i] = is_viscous ? f0[i] : enters ? stream : 6.0 * f0[i] - 8.0 * f1[i] + 3.0 * f2[i];
  }
}

}  // namespace pennon::dns

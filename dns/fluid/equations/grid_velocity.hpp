/// The velocity v_g of the moving grid where the equations need it, from that of its corners.
#pragma once

#include "dns/grid/field.hpp"

namespace pennon::dns {

/// The means over the four corners of each cell of a plane, and over the two of each face of the
/// wall (n_theta numbers). `corners`: rows 0 .. n_rho, columns 0 .. n_theta.
template <class Scalar>
void average_corners(int plane, const Field<Scalar>& corners, Field<Scalar>& cells, Scalar* wall) {
  const int n_rho = corners.extent().n_rho, n_theta = corners.extent().n_theta;
  for (int j = 0; j < n_rho; ++j) {
    const Scalar *below = corners.row(plane, j), *above = corners.row(plane, j + 1);
    Scalar* cell = cells.row(plane, j);
    for (int i = 0; i < n_theta; ++i)
      cell[i] = 0.25 * (below[i] + below[i + 1] + above[i] + above[i + 1]);
  }
  const Scalar* corner = corners.row(plane, 0);
  for (int i = 0; i < n_theta; ++i) wall[i] = 0.5 * (corner[i] + corner[i + 1]);
}

}  // namespace pennon::dns

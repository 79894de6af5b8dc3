/// The exact derivatives of PlaneEquations by the flow, from complex steps (Squire & Trapp 1998):
/// f'(q) h = Im f(q + i h) up to h^3. No difference is taken, so that nothing cancels and h may be
/// as small as one likes.
///
/// The equations of a cell depend on the unknowns of the cells at most two rows and columns away.
/// Unknowns five rows and columns apart therefore share an evaluation: 25 for each field (Curtis,
/// Powell & Reid 1974).
#pragma once

#include <Eigen/SparseCore>

#include "modes/global/equations/half_plane.hpp"

namespace pennon::modes::global {

/// The derivatives of R - dX/dx (PlaneEquations) by the unknowns of a disturbance that varies as
/// exp(i k_x x) are
///
///   in_plane + i k_x along_x - k_x^2 along_x_twice
///
/// with real matrices. Rows and columns are counted as HalfPlane counts unknowns.
struct Jacobian {
  Eigen::SparseMatrix<double> in_plane, along_x, along_x_twice;
  /// The derivatives of the force along z on each segment of the flag (rows) by the unknowns.
  Eigen::SparseMatrix<double> force;
};

/// The Jacobian at the flow q. `equations` has been given the grid, the grid's velocity and the
/// outer faces through which fluid enters. With `with_span` the two matrices of the variation along
/// x are found too; else they are empty.
Jacobian jacobian(PlaneEquations<std::complex<double>>& equations, const PlaneFlow<double>& q,
                  const HalfPlane& unknowns, bool with_span);

/// The length h of a complex step, here and in the derivatives by the grid (linear_fluid.cpp).
inline constexpr double complex_step = 1e-40;

/// The flow with zero imaginary parts, ghosts included.
PlaneFlow<std::complex<double>> complex_flow(const PlaneFlow<double>& q);

}  // namespace pennon::modes::global

/// The exact derivatives of PlaneEquations by the flow, from complex steps (Squire & Trapp 1998):
/// f'(q) h = Im f(q + i h) without a difference, so h may be as small as one likes.
///
/// A cell's equations know the unknowns of the cells at most two rows and columns away. Unknowns
/// five rows and columns apart share an evaluation: 25 for each field (Curtis, Powell & Reid 1974).
#pragma once

#include <Eigen/SparseCore>

#include "modes/global/equations/half_plane.hpp"

namespace pennon::modes::global {

/// Of R - dX/dx for disturbances that vary as exp(i k_x x): in_plane + i k_x along_x - k_x^2
/// along_x_twice, each real. Rows and columns as HalfPlane counts unknowns.
struct Jacobian {
  Eigen::SparseMatrix<double> in_plane, along_x, along_x_twice;
  Eigen::SparseMatrix<double> force;  ///< along z on each segment of the flag
};

/// About the flow q; `equations` holds the grid, its velocity and where fluid enters. With
/// `with_span` the parts along x are found too, else they are empty.
Jacobian jacobian(PlaneEquations<std::complex<double>>& equations, const PlaneFlow<double>& q,
                  const HalfPlane& unknowns, bool with_span);

/// The step.
inline constexpr double complex_step = 1e-40;

PlaneFlow<std::complex<double>> complex_flow(const PlaneFlow<double>& q);

}  // namespace pennon::modes::global

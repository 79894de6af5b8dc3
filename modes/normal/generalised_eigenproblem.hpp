/// The lowest eigenpairs of K v = lambda M v for K = E^T S E (semi-definite), M = E^T R E
/// (definite), all sparse, S and R symmetric.
///
/// ARPACK (Lehoucq, Sorensen & Yang 1998) finds them by shift and invert: the largest theta of
/// (K + s M)^-1 M, lambda = 1/theta - s. It works in double precision, and K itself, once its
/// factors are multiplied out, has lost the small energy of nearly rigid motions. So the vectors
/// are then corrected to v - (K + s M)^-1 (K v - lambda M v), where the residual K v - lambda M v
/// is formed from the factors in extended precision, and lambda is their Rayleigh-Ritz value.
#pragma once

#include <Eigen/Sparse>
#include <string>

#include "modes/normal/spline_space.hpp"

namespace pennon::modes {

using ExtendedSparse = Eigen::SparseMatrix<Extended>;

struct GeneralisedEigenproblem {
  ExtendedSparse E;  ///< from the unknowns to the values at points of which the energies are made
  ExtendedSparse S;  ///< energy densities times quadrature weights
  ExtendedSparse R;  ///< mass densities times quadrature weights
};

struct Eigenpairs {
  ExtendedVector lambda;  ///< increasing
  /// Columns with v^T M v = 1; the last component of at least 1% of the largest is positive.
  ExtendedMatrix vectors;
  /// The largest (c^T M c)^1/2 of the last corrections c: the relative error of 1/(lambda + s)
  /// before them was no larger.
  double worst_residual = 0;
};

inline constexpr double largest_residual = 1e-10;

/// The `count` pairs with the lowest lambda. The shift s > 0 keeps K + s M definite where K has a
/// null space; it is best near the lowest lambda. Precondition: 0 < count < E.cols(). The same
/// input gives the same bits. Throws SolverError, which begins with `what`, if K + s M is not
/// definite, fewer than `count` converge, or a residual exceeds `largest_residual`.
Eigenpairs lowest_eigenpairs(const GeneralisedEigenproblem&, int count, double shift,
                             const std::string& what);

}  // namespace pennon::modes

/// Singular value decompositions by LAPACK.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace pennon {

template <class Scalar>
using DenseMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// A = U diag(sigma) V^*, of an A that has entries. sigma falls and has as many numbers as A has
/// rows or columns, whichever are fewer; the columns of U and of V are orthonormal.
template <class Scalar>
struct Svd {
  DenseMatrix<Scalar> U;
  Eigen::VectorXd sigma;
  DenseMatrix<Scalar> V;
};

/// U and V have as many columns as sigma has numbers. For double and std::complex<double>. Throws
/// SolverError where A has an entry that is not finite, or the iteration does not converge.
template <class Scalar>
Svd<Scalar> thin_svd(DenseMatrix<Scalar> A);

/// U and V are square: their last columns span what A maps to zero, and what it does not reach.
template <class Scalar>
Svd<Scalar> full_svd(DenseMatrix<Scalar> A);

/// sigma alone.
template <class Scalar>
Eigen::VectorXd singular_values(DenseMatrix<Scalar> A);

}  // namespace pennon

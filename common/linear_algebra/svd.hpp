/// Singular value decompositions by LAPACK.
#pragma once

#include <Eigen/Core>
#include <complex>

namespace pennon {

template <class Scalar>
using DenseMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

/// A = U diag(sigma) V^*, of an A with at least one entry. sigma is in decreasing order and has as
/// many numbers as A has rows or columns, whichever are fewer; the columns of U and of V, the left
/// and right singular vectors, are orthonormal.
template <class Scalar>
struct Svd {
  DenseMatrix<Scalar> U;
  Eigen::VectorXd sigma;
  DenseMatrix<Scalar> V;
};

/// U and V have as many columns as sigma has numbers. This and the functions below are there for
/// double and std::complex<double>; they throw SolverError where A has an entry that is not finite,
/// or the iteration does not converge.
template <class Scalar>
Svd<Scalar> thin_svd(DenseMatrix<Scalar> A);

/// U and V are square. With r the rank of the matrix A, the columns of V behind the r-th span the
/// null space of A, and those of U the orthogonal complement of its range.
template <class Scalar>
Svd<Scalar> full_svd(DenseMatrix<Scalar> A);

/// sigma alone.
template <class Scalar>
Eigen::VectorXd singular_values(DenseMatrix<Scalar> A);

}  // namespace pennon

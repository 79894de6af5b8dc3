#include "common/linear_algebra/svd.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "common/errors.hpp"
#include "common/linear_algebra/lapacke.hpp"

namespace pennon {
namespace {

// How many of the singular vectors, in LAPACK's letters.
enum class Vectors : char { none = 'N', thin = 'S', full = 'A' };

lapack_int gesdd(char job, lapack_int m, lapack_int n, double* A, double* sigma, double* U,
                 lapack_int rows_of_U, double* VT, lapack_int rows_of_VT) {
  return LAPACKE_dgesdd(LAPACK_COL_MAJOR, job, m, n, A, m, sigma, U, rows_of_U, VT, rows_of_VT);
}

lapack_int gesdd(char job, lapack_int m, lapack_int n, std::complex<double>* A, double* sigma,
                 std::complex<double>* U, lapack_int rows_of_U, std::complex<double>* VT,
                 lapack_int rows_of_VT) {
  return LAPACKE_zgesdd(LAPACK_COL_MAJOR, job, m, n, A, m, sigma, U, rows_of_U, VT, rows_of_VT);
}

// Divide and conquer; overwrites A. LAPACKE looks for NaN in A first.
template <class Scalar>
Svd<Scalar> decomposed(DenseMatrix<Scalar>& A, Vectors vectors) {
  const Eigen::Index rows = A.rows(), columns = A.cols(), count = std::min(rows, columns);
  assert(count > 0);
  Svd<Scalar> svd;
  svd.sigma.resize(count);
  DenseMatrix<Scalar> VH(1, 1);
  svd.U.resize(1, 1);
  if (vectors != Vectors::none) {
    const bool is_full = vectors == Vectors::full;
    svd.U.resize(rows, is_full ? rows : count);
    VH.resize(is_full ? columns : count, columns);
  }
  const lapack_int info =
      gesdd(static_cast<char>(vectors), static_cast<lapack_int>(rows),
            static_cast<lapack_int>(columns), A.data(), svd.sigma.data(), svd.U.data(),
            static_cast<lapack_int>(svd.U.rows()), VH.data(), static_cast<lapack_int>(VH.rows()));
  if (info != 0 || !svd.sigma.allFinite())
    throw SolverError(fmt::format("the singular values of a matrix of {} x {} entries {}", rows,
                                  columns,
                                  info > 0 ? "were not found: LAPACK's iteration did not converge"
                                           : "do not exist: it has entries that are not finite"));
  svd.V = VH.adjoint();
  return svd;
}

}  // namespace

template <class Scalar>
Svd<Scalar> thin_svd(DenseMatrix<Scalar> A) {
  return decomposed(A, Vectors::thin);
}

template <class Scalar>
Svd<Scalar> full_svd(DenseMatrix<Scalar> A) {
  return decomposed(A, Vectors::full);
}

template <class Scalar>
Eigen::VectorXd singular_values(DenseMatrix<Scalar> A) {
  return decomposed(A, Vectors::none).sigma;
}

template struct Svd<double>;
template struct Svd<std::complex<double>>;
template Svd<double> thin_svd(DenseMatrix<double>);
template Svd<std::complex<double>> thin_svd(DenseMatrix<std::complex<double>>);
template Svd<double> full_svd(DenseMatrix<double>);
template Svd<std::complex<double>> full_svd(DenseMatrix<std::complex<double>>);
template Eigen::VectorXd singular_values(DenseMatrix<double>);
template Eigen::VectorXd singular_values(DenseMatrix<std::complex<double>>);

}  // namespace pennon

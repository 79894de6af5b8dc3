#include "common/linear_algebra/stacked_qr.hpp"

#include <algorithm>
#include <cassert>

#include "common/linear_algebra/lapacke.hpp"

namespace pennon {
namespace {

using Complex = std::complex<double>;

// Columns that LAPACK takes at once.
constexpr lapack_int block = 64;

void factor(lapack_int m, lapack_int n, double* A, double* tau) {
  LAPACKE_dgeqrf(LAPACK_COL_MAJOR, m, n, A, m, tau);
}
void factor(lapack_int m, lapack_int n, Complex* A, Complex* tau) {
  LAPACKE_zgeqrf(LAPACK_COL_MAJOR, m, n, A, m, tau);
}

// Of a triangle R above m rows B.
void factor_below(lapack_int m, lapack_int n, lapack_int nb, double* R, double* B, double* T) {
  LAPACKE_dtpqrt(LAPACK_COL_MAJOR, m, n, 0, nb, R, n, B, m, T, nb);
}
void factor_below(lapack_int m, lapack_int n, lapack_int nb, Complex* R, Complex* B, Complex* T) {
  LAPACKE_ztpqrt(LAPACK_COL_MAJOR, m, n, 0, nb, R, n, B, m, T, nb);
}

}  // namespace

template <class Scalar>
void StackedQr<Scalar>::add(DenseMatrix<Scalar> rows) {
  assert(rows.cols() == R_.cols());
  const Eigen::Index n = R_.cols();
  if (R_.rows() < n) {
    DenseMatrix<Scalar> all(R_.rows() + rows.rows(), n);
    all << R_, rows;
    if (all.rows() >= n) {
      DenseMatrix<Scalar> tau(n, 1);
      factor(static_cast<lapack_int>(all.rows()), static_cast<lapack_int>(n), all.data(),
             tau.data());
      R_ = all.topRows(n).template triangularView<Eigen::Upper>();
    } else {
      R_ = std::move(all);
    }
    return;
  }
  if (rows.rows() == 0) return;
  const lapack_int nb = std::min(block, static_cast<lapack_int>(n));
  DenseMatrix<Scalar> T(nb, n);
  factor_below(static_cast<lapack_int>(rows.rows()), static_cast<lapack_int>(n), nb, R_.data(),
               rows.data(), T.data());
}

template class StackedQr<double>;
template class StackedQr<std::complex<double>>;

}  // namespace pennon

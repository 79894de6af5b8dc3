/// The triangular factor of a tall matrix that comes in parts, by LAPACK.
#pragma once

#include "common/linear_algebra/svd.hpp"

namespace pennon {

/// R of A = Q R with orthonormal columns of Q, of parts A_1, A_2, ... one below the other; Q is not
/// kept. There for double and std::complex<double>.
template <class Scalar>
class StackedQr {
 public:
  explicit StackedQr(Eigen::Index columns) : R_(0, columns) {}

  /// Adds rows below those before.
  void add(DenseMatrix<Scalar> rows);

  /// min(rows so far, columns) x columns. While A has fewer rows than columns it is A itself, with
  /// Q = 1; from then on it is upper triangular, its diagonal of any sign.
  const DenseMatrix<Scalar>& R() const { return R_; }

 private:
  DenseMatrix<Scalar> R_;
};

extern template class StackedQr<double>;
extern template class StackedQr<std::complex<double>>;

}  // namespace pennon

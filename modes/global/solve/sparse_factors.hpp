/// Solves with a sparse matrix by its LU factors. The interface leaves open which library makes
/// them: UMFPACK (below), or MUMPS in the program of the global modes (slepc/mumps_factors.hpp).
#pragma once

#include <Eigen/SparseCore>
#include <algorithm>
#include <complex>
#include <memory>

namespace pennon::modes::global {

class SparseFactors {
 public:
  using Matrix = Eigen::SparseMatrix<std::complex<double>>;

  SparseFactors() = default;
  SparseFactors(const SparseFactors&) = delete;
  SparseFactors& operator=(const SparseFactors&) = delete;
  virtual ~SparseFactors() = default;

  /// Factors a matrix; the factors replace those of the last one. Matrices with the same pattern
  /// are analysed once. Throws SolverError where the matrix is singular or the memory is not
  /// enough.
  virtual void factor(const Matrix&) = 0;
  /// Solves for each column of `right`.
  virtual Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const = 0;
  /// Solves with the matrix transposed and conjugated.
  virtual Eigen::MatrixXcd solve_adjoint(const Eigen::MatrixXcd& right) const = 0;
};

/// Whether two compressed matrices have entries at the same places. Both are stored by columns, or
/// both by rows.
template <class Sparse>
bool have_same_pattern(const Sparse& a, const Sparse& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a.nonZeros() == b.nonZeros() &&
         std::equal(a.outerIndexPtr(), a.outerIndexPtr() + a.outerSize() + 1, b.outerIndexPtr()) &&
         std::equal(a.innerIndexPtr(), a.innerIndexPtr() + a.nonZeros(), b.innerIndexPtr());
}

/// Factors by UMFPACK.
std::shared_ptr<SparseFactors> umfpack_factors();

}  // namespace pennon::modes::global

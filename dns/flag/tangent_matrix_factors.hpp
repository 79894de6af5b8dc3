/// Factors of a sparse square matrix by SuiteSparse (Davis 2006): the two ways in which the tangent
/// of a flag with a span is solved. The pattern is analysed once.
///
/// Eigen's interfaces to SuiteSparse are not used: they allocate in each solution, do not form the
/// symmetric part of a matrix in the pattern of its lower triangle, and leave CHOLMOD its threads,
/// which slow it down here.
#pragma once

#include <cholmod.h>
#include <umfpack.h>

#include <Eigen/SparseCore>
#include <array>
#include <vector>

namespace pennon::dns {

/// A matrix to be factored: compressed, of a symmetric pattern; its values need not be symmetric.
using SparseTangent = Eigen::SparseMatrix<double>;

/// The symmetric part (A + A^T)/2 by CHOLMOD's supernodal Cholesky factors.
class CholeskyFactors {
 public:
  explicit CholeskyFactors(const SparseTangent& pattern);
  ~CholeskyFactors();
  CholeskyFactors(const CholeskyFactors&) = delete;
  CholeskyFactors& operator=(const CholeskyFactors&) = delete;

  /// False if the symmetric part is not positive definite.
  bool factor(const SparseTangent& matrix);
  /// Whether the factored matrix was symmetric but for rounding.
  bool is_exact() const { return is_exact_; }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  // An entry on or below the diagonal and its mirror image, by their places in the matrix.
  struct Pair {
    Eigen::Index entry, mirrored;
  };

  cholmod_common common_{};
  cholmod_sparse* lower_ = nullptr;
  std::vector<Pair> pairs_;  // in the order of lower_
  cholmod_factor* factors_ = nullptr;
  cholmod_dense* solution_ = nullptr;  // these three CHOLMOD allocates once and uses again
  cholmod_dense* y_ = nullptr;
  cholmod_dense* e_ = nullptr;
  bool is_exact_ = true;
};

/// Any regular matrix by UMFPACK's LU factors.
class LuFactors {
 public:
  explicit LuFactors(const SparseTangent& pattern);
  ~LuFactors();
  LuFactors(const LuFactors&) = delete;
  LuFactors& operator=(const LuFactors&) = delete;

  /// False if the matrix is singular to working precision.
  bool factor(const SparseTangent& matrix);
  /// `matrix`: the one that was factored.
  void solve(const SparseTangent& matrix, const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  std::array<double, UMFPACK_CONTROL> control_{};
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  std::vector<int> integers_;  // work space of a solution
  std::vector<double> reals_;
};

}  // namespace pennon::dns

/// Factors of a sparse square matrix by SuiteSparse (Davis 2006): the two ways in which the tangent
/// of a flag with a span is solved. The pattern is analysed once.
#pragma once

#include <cholmod.h>
#include <umfpack.h>

#include <Eigen/Core>
#include <array>
#include <vector>

namespace pennon::dns {

/// Rows increase along each column; the pattern is symmetric, the values need not be.
struct CompressedColumns {
  std::vector<int> columns;  ///< where each begins in `rows`, and the end of the last
  std::vector<int> rows;
  std::vector<double> values;

  int order() const { return static_cast<int>(columns.size()) - 1; }
  /// b - A x, into `residual`.
  void evaluate_residual(const Eigen::VectorXd& x, const Eigen::VectorXd& b,
                         Eigen::VectorXd& residual) const;
  /// Subtracts A x.
  void subtract_product(const Eigen::VectorXd& x, Eigen::VectorXd& sum) const;
};

/// The symmetric part (A + A^T)/2 by CHOLMOD's supernodal Cholesky factors.
class CholeskyFactors {
 public:
  explicit CholeskyFactors(const CompressedColumns& pattern);
  ~CholeskyFactors();
  CholeskyFactors(const CholeskyFactors&) = delete;
  CholeskyFactors& operator=(const CholeskyFactors&) = delete;

  /// False if the symmetric part is not positive definite.
  bool factor(const CompressedColumns& matrix);
  /// Whether the factored matrix was symmetric but for rounding.
  bool is_exact() const { return is_exact_; }
  void solve(const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  // An entry on or below the diagonal and its mirror image, by their places in the matrix.
  struct Pair {
    std::size_t entry, mirrored;
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
  explicit LuFactors(const CompressedColumns& pattern);
  ~LuFactors();
  LuFactors(const LuFactors&) = delete;
  LuFactors& operator=(const LuFactors&) = delete;

  /// False if the matrix is singular to working precision.
  bool factor(const CompressedColumns& matrix);
  /// `matrix`: the one that was factored.
  void solve(const CompressedColumns& matrix, const Eigen::VectorXd& b, Eigen::VectorXd& x);

 private:
  std::array<double, UMFPACK_CONTROL> control_{};
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
  std::vector<int> integers_;  // work space of a solution
  std::vector<double> reals_;
};

}  // namespace pennon::dns

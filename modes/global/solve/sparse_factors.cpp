#include "modes/global/solve/sparse_factors.hpp"

#include <Eigen/UmfPackSupport>

#include "common/errors.hpp"

namespace pennon::modes::global {
namespace {

// Eigen's interface, and UMFPACK's solution with the conjugate transpose, which it has not.
class Umfpack : public Eigen::UmfPackLU<SparseFactors::Matrix> {
 public:
  bool solve_adjoint(const Eigen::VectorXcd& right, Eigen::VectorXcd& solution) const {
    return Eigen::umfpack_solve(UMFPACK_At, mp_matrix.outerIndexPtr(), mp_matrix.innerIndexPtr(),
                                mp_matrix.valuePtr(), solution.data(), right.data(), m_numeric,
                                m_control.data(), m_umfpackInfo.data()) == UMFPACK_OK;
  }
};

class UmfpackFactors final : public SparseFactors {
 public:
  UmfpackFactors() {
    // The solutions are good to rounding as they are, and three times as fast without refinement.
    factors_.umfpackControl()(UMFPACK_IRSTEP) = 0;
  }

  void factor(const Matrix& matrix) override {
    const bool is_known = have_same_pattern(matrix, matrix_);
    matrix_ = matrix;
    if (!is_known) factors_.analyzePattern(matrix_);
    factors_.factorize(matrix_);
    if (factors_.info() != Eigen::Success)
      throw SolverError("the matrix is singular, or its factors do not fit into memory");
  }

  Eigen::MatrixXcd solve(const Eigen::MatrixXcd& right) const override {
    return factors_.solve(right);
  }

  Eigen::MatrixXcd solve_adjoint(const Eigen::MatrixXcd& right) const override {
    Eigen::MatrixXcd solution(right.rows(), right.cols());
    Eigen::VectorXcd column(right.rows());
    for (Eigen::Index k = 0; k < right.cols(); ++k) {
      if (!factors_.solve_adjoint(right.col(k), column))
        throw SolverError("UMFPACK could not solve with the adjoint matrix");
      solution.col(k) = column;
    }
    return solution;
  }

 private:
  Matrix matrix_;  // the factors refer to it
  Umfpack factors_;
};

}  // namespace

std::shared_ptr<SparseFactors> umfpack_factors() {
  return std::make_shared<UmfpackFactors>();
}

}  // namespace pennon::modes::global

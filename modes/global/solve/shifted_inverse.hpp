/// (A - target B)^-1 of a pencil, applied to vectors, as shift and invert needs it.
#pragma once

#include <Eigen/LU>
#include <complex>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/aerodynamic_matrix.hpp"

namespace pennon::modes::global {

class ShiftedInverse {
 public:
  ShiftedInverse() = default;
  ShiftedInverse(const ShiftedInverse&) = delete;
  ShiftedInverse& operator=(const ShiftedInverse&) = delete;
  virtual ~ShiftedInverse() = default;

  /// q with (A - target B) q = b.
  virtual Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const = 0;
  /// p with (A - target B)^H p = c.
  virtual Eigen::VectorXcd solve_adjoint(const Eigen::VectorXcd& c) const = 0;
};

/// The inverse of a pencil of sparse matrices, by factors of A - target B.
class ShiftedSparse final : public ShiftedInverse {
 public:
  /// Throws SolverError where the target is an eigenvalue.
  ShiftedSparse(const SparsePencil&, std::complex<double> target, std::shared_ptr<SparseFactors>);

  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const override;
  Eigen::VectorXcd solve_adjoint(const Eigen::VectorXcd& c) const override;

 private:
  std::shared_ptr<SparseFactors> factors_;
};

/// The inverse of the coupled operator, whose columns for the flag are dense: only the flow's block
/// is factored, and the flag's unknowns are found from the Schur complement
///
///   S = F(target) - K - target^2 M                              (aerodynamic_matrix.hpp).
///
/// Let b = (b_v, b_z, b_t) be the right side and L = A_vv - target B_vv. The middle row gives
/// zeta_t = target zeta + b_z, and with w = L^-1 (b_v - A_vt b_z)
///
///   S zeta = b_t - A_tv w - (F_t - target M) b_z,     q_v = w + X zeta,
///
/// so that one solution with L is needed. The adjoint is solved likewise, p_z from the last column.
/// With the target near an eigenvalue S is nearly singular, and the other modes are found with
/// larger errors than by factors of the whole matrix: ten times larger at a distance of 1e-5,
/// hardly larger at 0.3.
class ShiftedCoupled final : public ShiftedInverse {
 public:
  /// Throws SolverError where the target is an eigenvalue of the flow past the flag at rest.
  /// `coupled` must outlive this.
  ShiftedCoupled(const CoupledOperator& coupled, std::complex<double> target,
                 std::shared_ptr<SparseFactors>);

  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const override;
  Eigen::VectorXcd solve_adjoint(const Eigen::VectorXcd& c) const override;

 private:
  const CoupledOperator& coupled_;
  std::complex<double> target_;
  AerodynamicMatrix response_;
  Eigen::MatrixXcd by_velocity_;  // F_t - target M
  Eigen::PartialPivLU<Eigen::MatrixXcd> complement_, adjoint_complement_;
};

}  // namespace pennon::modes::global

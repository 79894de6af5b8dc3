/// (A - target B)^-1 of a pencil, as solutions: what shift and invert needs.
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

/// Of sparse matrices, factored as they are.
class ShiftedSparse final : public ShiftedInverse {
 public:
  /// Throws SolverError where the target is an eigenvalue.
  ShiftedSparse(const SparsePencil&, std::complex<double> target, std::shared_ptr<SparseFactors>);

  Eigen::VectorXcd solve(const Eigen::VectorXcd& b) const override;
  Eigen::VectorXcd solve_adjoint(const Eigen::VectorXcd& c) const override;

 private:
  std::shared_ptr<SparseFactors> factors_;
};

/// Of the coupled operator, whose columns for the flag are dense: only the flow's block is
/// factored, and the flag's unknowns are found from its Schur complement
///
///   S = F(target) - K - target^2 M                              (aerodynamic_matrix.hpp).
///
/// With b = (b_v, b_z, b_e) and eta = target zeta + b_z from the middle row, w = V^-1 (b_v - D_e
/// b_z) and V = A_vv - target B_vv,
///
///   S zeta = b_e - A_ev w - (F_e - target M) b_z,     v = w + X zeta,
///
/// one solution with V. Likewise of the adjoint, from the last column for p_z. Next to an
/// eigenvalue S is nearly singular, and the other modes are found less well than by factors of the
/// whole matrix: ten times at a distance of 1e-5, hardly at 0.3.
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
  Eigen::MatrixXcd by_velocity_;  // F_e - target M
  Eigen::PartialPivLU<Eigen::MatrixXcd> complement_, adjoint_complement_;
};

}  // namespace pennon::modes::global

/// The response of the fluid to the flag: the aerodynamic matrix F(lambda; Re, k_x). It takes the
/// motion zeta exp(i k_x x + lambda t) of the flag's free nodes to the force on them along z. With
/// it the coupled equations A q = lambda B q (coupled_operator.hpp) become those of the flag alone,
///
///   [lambda^2 M + K - F(lambda)] zeta = 0,     M = mu m.
///
/// This is no approximation: the flow's unknowns q_v are eliminated. By their rows
/// (linear_fluid.hpp)
///
///   q_v = X zeta,     X = -(A_vv - lambda B_vv)^-1 (A_vz + lambda A_vt),
///   F(lambda) = A_tv X + F_z + lambda F_t.
///
/// F depends on the steady flow, the grid and k_x, but not on mu, K_B and nu_s.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>

#include "modes/global/equations/linear_fluid.hpp"
#include "modes/global/solve/sparse_factors.hpp"

namespace pennon::modes::global {

class AerodynamicMatrix {
 public:
  /// at() computes the factors of A_vv - lambda B_vv in `factors`, and the functions below it use
  /// them. Others may share `factors`; once one of them has factored another matrix there, at() has
  /// to be called again before these functions.
  AerodynamicMatrix(std::shared_ptr<const LinearFluid>, std::shared_ptr<SparseFactors> factors);

  Eigen::Index flag_nodes() const { return fluid_->flag_nodes; }

  /// F(lambda), n x n of the flag's free nodes, in rho_f V^2: one sparse factorisation and n
  /// solutions. Throws SolverError where lambda is an eigenvalue of the flow past the flag at rest.
  Eigen::MatrixXcd at(std::complex<double> lambda);

  // The following are at the lambda of the last at().

  /// dF/dlambda zeta, by one more solution: with q_v = X zeta, its derivative by lambda satisfies
  /// (A_vv - lambda B_vv) dq_v/dlambda = B_vv q_v - A_vt zeta.
  Eigen::VectorXcd derivative(const Eigen::VectorXcd& zeta);
  /// The vector (q_v; zeta; lambda zeta) of the coupled operator for the shape zeta of a mode.
  Eigen::VectorXcd mode(const Eigen::VectorXcd& zeta) const;
  /// X, unknowns of the flow x free nodes, and the factors of A_vv - lambda B_vv.
  const Eigen::MatrixXcd& flow_response() const { return X_; }
  const SparseFactors& factors() const { return *factors_; }

 private:
  std::shared_ptr<const LinearFluid> fluid_;
  std::shared_ptr<SparseFactors> factors_;
  std::complex<double> lambda_;
  Eigen::MatrixXcd X_;
};

}  // namespace pennon::modes::global

/// The response of the fluid to the flag: the aerodynamic matrix F(lambda; Re, k_x), from the
/// motion zeta exp(i k_x x + lambda t) of the flag's nodes to the force on them. With it the
/// coupled equations A q = lambda B q (coupled_operator.hpp) become those of the flag alone,
///
///   [lambda^2 M + K - F(lambda)] zeta = 0,     M = mu m,
///
/// without approximation: the flow's unknowns are eliminated (linear_fluid.hpp),
///
///   v(lambda) zeta = X zeta,     X = -(A_vv - lambda B_vv)^-1 (D_z + lambda D_e),
///   F(lambda) = A_ev X + F_z + lambda F_e.
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
  /// `factors` may be shared: at() factors anew, and all that follows it uses these factors until
  /// someone else factors another matrix.
  AerodynamicMatrix(std::shared_ptr<const LinearFluid>, std::shared_ptr<SparseFactors> factors);

  Eigen::Index flag_nodes() const { return fluid_->flag_nodes; }

  /// F(lambda), n x n of the flag's free nodes, in rho_f V^2: one sparse factorisation and n
  /// solutions. Throws SolverError where lambda is an eigenvalue of the flow past the flag at rest.
  Eigen::MatrixXcd at(std::complex<double> lambda);

  // The following are at the lambda of the last at().

  /// F'(lambda) zeta, by one more solution: (A_vv - lambda B_vv) v' = B_vv v - D_e zeta.
  Eigen::VectorXcd derivative(const Eigen::VectorXcd& zeta);
  /// The mode (v, p; zeta; lambda zeta) of the coupled operator that goes with a motion of the
  /// flag.
  Eigen::VectorXcd mode(const Eigen::VectorXcd& zeta) const;
  /// X, and the factors of A_vv - lambda B_vv.
  const Eigen::MatrixXcd& flow() const { return X_; }
  const SparseFactors& factors() const { return *factors_; }

 private:
  std::shared_ptr<const LinearFluid> fluid_;
  std::shared_ptr<SparseFactors> factors_;
  std::complex<double> lambda_;
  Eigen::MatrixXcd X_;
};

}  // namespace pennon::modes::global

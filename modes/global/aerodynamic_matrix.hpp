/// What the fluid does to the flag: the aerodynamic matrix F(lambda; Re, k_x), from the motion
/// zeta exp(i k_x x + lambda t) of the flag's nodes to the force on them. With it the coupled
/// equations A q = lambda B q (coupled_operator.hpp) are those of the flag alone,
///
///   [lambda^2 M + K - F(lambda)] zeta = 0,     M = mu m,
///
/// exactly: the flow's unknowns are eliminated,
///
///   v(lambda) = -(A_vv - lambda B_vv)^-1 (A_vz + lambda A_ve) zeta,
///   F(lambda) zeta = A_ev v(lambda) + (F_d + lambda F_dt) zeta
///
/// with z, e for zeta and d zeta/dt. F knows the steady flow, the grid and k_x, but not mu, K_B,
/// nu_s.
#pragma once

#include <Eigen/Core>
#include <complex>
#include <memory>

#include "modes/global/coupled_operator.hpp"

namespace pennon::modes::global {

class AerodynamicMatrix {
 public:
  /// `stiffness`: K of the flag that `coupled` was made with, which does not count here.
  AerodynamicMatrix(const CoupledOperator& coupled, const Eigen::MatrixXcd& stiffness);
  ~AerodynamicMatrix();
  AerodynamicMatrix(const AerodynamicMatrix&) = delete;
  AerodynamicMatrix& operator=(const AerodynamicMatrix&) = delete;
  AerodynamicMatrix(AerodynamicMatrix&&) noexcept;
  AerodynamicMatrix& operator=(AerodynamicMatrix&&) noexcept;

  Eigen::Index flag_nodes() const;

  /// F(lambda), n x n of the flag's free nodes, in rho_f V^2: one sparse factorisation and n
  /// solutions. Throws SolverError where lambda is an eigenvalue of the flow past the flag at rest.
  Eigen::MatrixXcd at(std::complex<double> lambda);

  /// F'(lambda) zeta at the lambda of the last at(): one more solution,
  /// (A_vv - lambda B_vv) v' = B_vv v - A_ve zeta.
  Eigen::VectorXcd derivative(const Eigen::VectorXcd& zeta);

  /// The mode (v, p; zeta; lambda zeta) of the coupled operator that goes with a motion of the flag
  /// at the lambda of the last at().
  Eigen::VectorXcd mode(const Eigen::VectorXcd& zeta) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace pennon::modes::global

/// The pressure on a flat strip 0 <= y <= 1 that accelerates in still fluid with a(y) cos(k_x x):
/// linear potential flow, no circulation, no wake.
///
/// The acceleration potential obeys psi_yy + psi_zz = k_x^2 psi with psi_z = a on the strip. On
/// y + i z = 1/2 + 1/2 cosh(rho + i theta) it separates, psi = sum g_j(rho) q_j(theta), into
///
///   -q'' + (k_x^2/4) sin^2(theta) q = lambda q,   g'' = (lambda + (k_x^2/4) sinh^2(rho)) g
///
/// (Mathieu functions of imaginary argument). The q_j come from a tridiagonal eigenproblem in
/// sin(n theta). The g_j enter only by sigma_j = -g'(0)/g(0), from the Riccati equation
/// sigma' = sigma^2 - lambda - (k_x^2/4) sinh^2(rho), integrated inwards, where the error of its
/// initial value decays. At k_x = 0, sigma_n = n, and a plunging plate has c_m = pi/4. As k_x
/// grows, p tends to 2 a/k_x.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace pennon::lsa {

class PlatePressure {
 public:
  static constexpr double largest_wavenumber = 1e3;

  /// `terms` sines in theta; the error falls exponentially with them. Throws SolverError where
  /// |k_x| is beyond largest_wavenumber.
  PlatePressure(double k_x, int terms);

  /// The jump p (above minus below) that opposes the acceleration a(y): the coefficients f_n of
  /// p = sum f_n sin(n theta), n = 1..terms, with y = (1 + cos theta)/2.
  Eigen::VectorXd opposing(const std::function<double(double y)>& acceleration) const;

 private:
  Eigen::MatrixXd compliance_;  // from the sines of psi_rho at the strip to those of p
};

}  // namespace pennon::lsa

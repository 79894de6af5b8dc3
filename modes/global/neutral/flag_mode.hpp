/// One mode of the flag's equations for a mass ratio,
///
///   S(lambda; mu) zeta = [lambda^2 mu m + K - F(lambda)] zeta = 0        (aerodynamic_matrix.hpp),
///
/// by Newton's method with a border, for (zeta, lambda) together:
///
///   [S, S' zeta; zeta_0^H, 0] (d zeta, d lambda) = (-S zeta, 0),     S' = dS/d lambda.
///
/// F is the fluid's response or a fit to it; the flag is the whole flag or one in a basis of few
/// shapes (flag_basis.hpp).
#pragma once

#include <complex>
#include <optional>

#include "modes/global/neutral/neutral.hpp"

namespace pennon::modes::global {

struct FlagMode {
  std::complex<double> lambda;
  Eigen::VectorXcd zeta;              ///< of length 1
  std::complex<double> by_mu;         ///< d lambda/d mu
  Eigen::VectorXcd shape_by_mu = {};  ///< d zeta/d mu, orthogonal to zeta; empty: not known
};

/// The mode near a guess at a mass ratio; `flag` with mu = 1. None where Newton's method does not
/// converge.
std::optional<FlagMode> flag_mode(const Aerodynamics&, const FlagOperator& flag, double mu,
                                  std::complex<double> lambda_0, const Eigen::VectorXcd& zeta_0);

/// A mode at a mass ratio.
struct FollowedMode {
  double mu;
  FlagMode mode;
};

/// The mode at another mass ratio. The guess is extrapolated from `last` with its derivative by mu
/// and, where it is given, through `before`: by a cubic for lambda and a parabola for zeta. A step
/// at whose end the mode is not found is halved; none where that does not help.
std::optional<FlagMode> followed(const Aerodynamics&, const FlagOperator& flag,
                                 const std::optional<FollowedMode>& before,
                                 const FollowedMode& last, double mu);

/// The error of lambda, to first order, if F is right: the step of lambda that Newton's method
/// would take from the mode with this F.
std::complex<double> correction(const Aerodynamics&, const FlagOperator& flag, double mu,
                                const FlagMode&);

/// The adjoint mode psi, psi^H S = 0 and psi^H S' zeta = 1.
Eigen::VectorXcd left_shape(const Aerodynamics&, const FlagOperator& flag, double mu,
                            const FlagMode&);

}  // namespace pennon::modes::global

/// One mode of the flag's equations for a mass ratio,
///
///   S(lambda; mu) zeta = [lambda^2 mu m + K - F(lambda)] zeta = 0        (aerodynamic_matrix.hpp),
///
/// by Newton's method with a border, for (zeta, lambda) together:
///
///   [S, S' zeta; zeta_0^H, 0] (d zeta, d lambda) = (-S zeta, 0),     S' = dS/d lambda.
///
/// F is the fluid's response or a fit of it, the flag the whole one or a reduced one
/// (flag_basis.hpp).
#pragma once

#include <complex>
#include <optional>

#include "modes/global/neutral/neutral.hpp"

namespace pennon::modes::global {

struct FlagMode {
  std::complex<double> lambda;
  Eigen::VectorXcd zeta;              ///< of length 1
  std::complex<double> by_mu;         ///< d lambda/d mu
  Eigen::VectorXcd shape_by_mu = {};  ///< d zeta/d mu, across zeta; empty: not known
};

/// The mode next to a guess at a mass ratio. `flag` with mu = 1. None where it does not converge.
std::optional<FlagMode> flag_mode(const Aerodynamics&, const FlagOperator& flag, double mu,
                                  std::complex<double> lambda_0, const Eigen::VectorXcd& zeta_0);

/// A mode at a mass ratio.
struct FollowedMode {
  double mu;
  FlagMode mode;
};

/// The mode followed to another mass ratio, by shorter steps where it is lost: from where the last
/// one points and, where there is one, by the curve through the one before, of third order for
/// lambda and second for zeta.
std::optional<FlagMode> followed(const Aerodynamics&, const FlagOperator& flag,
                                 const std::optional<FollowedMode>& before,
                                 const FollowedMode& last, double mu);

/// What an error of F or of zeta does to lambda, to first order: the step that Newton's method
/// would take with this F.
std::complex<double> correction(const Aerodynamics&, const FlagOperator& flag, double mu,
                                const FlagMode&);

/// psi of the mode from the left, psi^H S = 0.
Eigen::VectorXcd left_shape(const Aerodynamics&, const FlagOperator& flag, double mu,
                            const FlagMode&);

}  // namespace pennon::modes::global

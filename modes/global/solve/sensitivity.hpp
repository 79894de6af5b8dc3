/// The derivatives of an eigenvalue by parameters of the flag. With the adjoint mode p, A^H p =
/// conj(lambda) B^H p and p^H B q = 1,
///
///   d lambda = p^H (dA - lambda dB) q.
///
/// The flow does not depend on mu, K_B and nu_s, so only the flag's block changes.
#pragma once

#include <functional>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// Derivatives of lambda.
struct Sensitivity {
  std::complex<double> mu, K_B, nu_s;
  std::complex<double> tension;  ///< d lambda/d ln T, where all tension grows in proportion
};

/// Makes the operator of the flag with another material and with `share` times its tension.
using FlagOf = std::function<FlagOperator(const dns::FlagMaterial&, double share)>;

/// Precondition: the pair has its adjoint, scaled as above.
Sensitivity sensitivity(const Eigenpair&, const CoupledOperator&, const dns::FlagMaterial&,
                        const FlagOf&);

}  // namespace pennon::modes::global

/// The normal modes of a flag whose chordwise tension T_0 (1-y) falls linearly to the trailing edge
/// and whose spanwise tension is constant:
///
///   Y = J_0(alpha_0m sqrt(1-y)),   mu omega^2 = T_0 alpha_0m^2/4 + T_x k_x^2
///   T_0 = 1.3 Re^-1/2,   T_x = nu_s T_0
///
/// with J_0(alpha_0m) = 0, orthogonal with the weight w = 1: the modes of a hanging chain (D.
/// Bernoulli 1738). Appendix C of Banerjee, Connell & Yue (2015) makes these assumptions in words
/// ("the spanwise tension is bounded by the maximum chordwise tension"), but writes C 1, see
/// bessel.hpp. The trailing edge moves for every n. The modes depend neither on bending nor on how
/// the leading edge is held.
#pragma once

#include "modes/normal/normal_modes.hpp"

namespace pennon::modes {

/// Preconditions: mu > 0, Re > 0. Throws InputError for m that bessel_zero does not offer.
NormalModes hanging_chain_modes(const ModeRange&, const FlagParameters&, const FlowParameters&);

}  // namespace pennon::modes

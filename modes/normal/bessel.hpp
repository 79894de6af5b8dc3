/// The normal modes of Banerjee, Connell & Yue (2015), C 5:
///
///   Y = J_n(alpha_nm (1-y)),   omega = c alpha_nm,   c^2 = 1.3 Re^-1/2/mu
///
/// with J_n(alpha_nm) = 0, orthogonal with the weight w = 1-y. They solve C 1 in its consistent
/// form zeta_tt = c^2 (zeta_ss + zeta_s/s + zeta_xx/s^2), s = 1-y, in which x is the angle of a
/// wedge; for n >= 1 they vanish at the trailing edge too. They depend neither on bending nor on
/// the Poisson ratio nor on how the leading edge is held.
#pragma once

#include "modes/normal/normal_modes.hpp"

namespace pennon::modes {

/// Preconditions: mu > 0, Re > 0. Throws InputError for n or m that bessel_zero does not offer.
NormalModes bessel_modes(const ModeRange&, const FlagParameters&, const FlowParameters&);

}  // namespace pennon::modes

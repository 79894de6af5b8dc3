/// Where a global mode has its energy.
///
/// The energy of a mode exp(lambda t) in a section x = const, per unit span and in rho_f V^2 L^2,
/// is the mean over a phase of
///
///   E = 1/2 int |v'|^2 dy dz + 1/2 (zeta_t^H M zeta_t + zeta^H K zeta),
///
/// v' the velocity at fixed points (mode_fields.hpp), which does not depend on how the grid follows
/// the flag, M and K the flag's mass and stiffness (flag_operator.hpp): the fluid's kinetic energy
/// over the whole plane of the grid, and the flag's kinetic energy with that of its bending and its
/// tension. The factor of the mean over a phase, 1/2, is left out: it is common to all.
#pragma once

#include "modes/global/solve/spectrum.hpp"
#include "modes/global/study/fixed_points.hpp"

namespace pennon::modes::global {

/// Parts of E, which add up to 1. Distances are in L; r is that from mid-chord.
struct EnergyShares {
  double flag = 0;   ///< kinetic and elastic
  double near = 0;   ///< the fluid elsewhere
  double wake = 0;   ///< the fluid at y > wake_begin, r <= R/2
  double outer = 0;  ///< the fluid at r > R/2
};

inline constexpr double wake_begin = 1.5;

EnergyShares energy_shares(const OGrid&, const CoupledOperator&, const FixedPoints&,
                           const Eigenpair&);

}  // namespace pennon::modes::global

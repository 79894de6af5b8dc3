/// A global mode as fields of the whole plane.
///
/// The unknowns of coupled_operator.hpp are those at points that move with the grid, displaced by d
/// = G zeta: regular everywhere, but they depend on how the grid follows the flag. At fixed points
/// the disturbance is, to first order,
///
///   v' = v - (d . grad) v_0,
///
/// v_0 the velocity of the steady flow; the same of the pressure and of the vorticity. It does not
/// depend on the grid, but at the trailing edge v' is singular as dv_0/dz is, as r^-1/2. Both are
/// given.
///
/// Scales: L, V, rho_f. The node of the flag that moves most has the displacement 1.
#pragma once

#include <complex>
#include <optional>
#include <vector>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/spectrum.hpp"
#include "modes/global/solve/wavemaker.hpp"

namespace pennon::modes::global {

struct ModeFields {
  PlaneFlow<std::complex<double>> moving;           ///< v at points that move with the grid
  Field<std::complex<double>> moving_vorticity;     ///< omega_x there
  PlaneFlow<std::complex<double>> fixed;            ///< v'
  Field<std::complex<double>> fixed_vorticity;      ///< omega_x' = dw'/dy - dv'/dz
  Displacement<std::complex<double>> displacement;  ///< d of the corners
  std::vector<std::complex<double>> zeta;           ///< at the flag's nodes, from the leading edge
  std::optional<AdjointFields> adjoint = {};
};

/// The modes, and what of the steady flow is drawn with them.
struct FieldsOfModes {
  std::vector<double> points;    ///< y, z of the grid's corners at rest, [rho][theta]
  Field<double> base_vorticity;  ///< omega_x of the steady flow at the cells
  std::vector<ModeFields> modes;
};

/// Adjoint and wavemaker of the pairs that have one. Precondition: `pairs` are of `coupled`, and
/// that is of the grid and the base flow.
FieldsOfModes fields_of_modes(const OGrid&, const BaseFlow&, const CoupledOperator&,
                              const std::vector<Eigenpair>& pairs);

/// What the largest displacement of the flag is in a mode: its eigenvector is divided by this.
std::complex<double> scale_of(const Eigenpair&, const CoupledOperator&);

}  // namespace pennon::modes::global

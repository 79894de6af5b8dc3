/// Where in flow and flag a feedback changes a mode most: the wavemaker (Giannetti & Luchini 2007,
/// "structural sensitivity").
///
/// A force C v' per volume, proportional to the velocity disturbance at the same fixed point and
/// confined to a spot of area dA, changes the eigenvalue by
///
///   d lambda = p^* . C v' dA,     |d lambda| <= |C| |p| |v'| dA,
///
/// where p is the velocity of the adjoint mode with p^H B q = 1 over the whole plane, and |C| the
/// largest singular value of the 2 x 2 (with a span 3 x 3) matrix. The wavemaker is |p| |v'|, the
/// product of the Euclidean norms of the complex velocities; the bound is met by
/// C = p v'^H/(|p| |v'|). Its unit is 1/L^2, so that times C (V/L) and dA (L^2) it is a growth
/// rate; it does not depend on how q is scaled. On the flag a force c zeta_t per area (of rho_f V)
/// confined to a piece dy changes the eigenvalue by
///
///   d lambda = p_f^* c zeta_t dy,
///
/// where p_f is the part of p in the rows of the flag's equation of motion, so |p_f| |zeta_t| (in
/// 1/L) is the flag's part of the wavemaker. The derivatives of lambda by mass, damping and
/// stiffness that are added to a piece of the flag follow from the same product.
///
/// The pencil describes half of the plane. With p^H B q = 1 over the whole plane the velocities of
/// p are half of those of the pencil's adjoint; a feedback at a cell and at its mirror image
/// changes lambda by twice the above.
#pragma once

#include <complex>
#include <vector>

#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// Values at the flag's nodes from the leading edge; 0 where it is held.
struct FlagFeedback {
  std::vector<double> wavemaker;                ///< |p_f| |zeta_t|, 1/L
  std::vector<std::complex<double>> mass;       ///< d lambda by mass per area (rho_f L) and length
  std::vector<std::complex<double>> damping;    ///< by a force - c zeta_t per area, c in rho_f V
  std::vector<std::complex<double>> stiffness;  ///< by a force - k zeta per area, k in rho_f V^2/L
};

/// The adjoint mode in the whole plane, and the wavemaker.
struct AdjointFields {
  PlaneFlow<std::complex<double>> p;  ///< scaled to the mode as it is written
  Field<double> wavemaker;            ///< |p| |v'| at the cells, 1/L^2
  FlagFeedback flag;
};

/// The fields of a pair with an adjoint, scaled to p^H B q = 1. `fixed` is v' of the mode q/scale
/// at fixed points.
AdjointFields adjoint_fields(const Eigenpair&, const CoupledOperator&,
                             const PlaneFlow<std::complex<double>>& fixed,
                             std::complex<double> scale);

/// The feedback on the flag alone.
FlagFeedback flag_feedback(const Eigenpair&, const CoupledOperator&);

}  // namespace pennon::modes::global

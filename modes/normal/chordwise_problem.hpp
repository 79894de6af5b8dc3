/// The chordwise shapes of a flag's modes in vacuum, for one spanwise wavenumber:
///
///   K_B (Y'''' - 2 k_x^2 Y'' + k_x^4 Y) - (T Y')' + R Y = lambda w Y,   lambda = mu omega^2
///
/// found as the stationary points of the energy: the integral over 0 <= y <= 1 of
///
///   K_B [(Y'' - k_x^2 Y)^2 + 2(1-nu_s)(k_x^2 Y Y'' + k_x^2 Y'^2)] + T Y'^2 + R Y^2
///
/// over that of w Y^2. The plate's term is Kirchhoff's, so its natural conditions hold at the free
/// edge y = 1:
///
///   Y'' - nu_s k_x^2 Y = 0,   K_B (Y''' - (2-nu_s) k_x^2 Y') = T Y'.
///
/// T is the chordwise tension, R the spanwise one times k_x^2, w the mass over mu. The scales are
/// L, V and rho_f.
#pragma once

#include <string>

#include "modes/normal/generalised_eigenproblem.hpp"
#include "modes/normal/normal_modes.hpp"
#include "modes/normal/spline_space.hpp"

namespace pennon::modes {

struct ChordwiseProblem {
  Profile weight;                                  ///< w
  Profile tension;                                 ///< T, >= 0
  Profile spanwise;                                ///< R, >= 0
  double K_B = 0;                                  ///< bending stiffness
  double nu_s = 0;                                 ///< Poisson ratio
  double k_x = 0;                                  ///< spanwise wavenumber
  LeadingEdge leading_edge = LeadingEdge::pinned;  ///< clamped is pinned where K_B = 0
  bool is_held_at_trailing_edge = false;           ///< Y(1) = 0
  double scale = 1;                                ///< of lambda: a typical T + K_B
};

struct ChordwiseShapes {
  std::vector<double> lambda;                ///< increasing
  std::vector<ExtendedVector> coefficients;  ///< in the space; the integral of w Y^2 is 1
  double worst_residual;
};

/// The `count` shapes with the lowest lambda. Throws SolverError, which begins with `what`; see
/// generalised_eigenproblem.hpp. Precondition: count < space.size() - 2.
ChordwiseShapes solve(const ChordwiseProblem&, const SplineSpace&, int count,
                      const std::string& what);

}  // namespace pennon::modes

/// The physical parameters of a flag in a stream, scaled by the chord L, the inflow V and the fluid
/// density rho_f. Axes: x spanwise, y streamwise from the leading edge, z normal to the flag.
#pragma once

#include <array>
#include <optional>

#include "common/case/range.hpp"
#include "common/case/schema.hpp"

namespace pennon {

enum class LeadingEdge { pinned, clamped };

struct FlagParameters {
  double mu = 0;                              ///< mass ratio rho_s h/(rho_f L)
  double K_B = 0;                             ///< bending stiffness EI/(rho_f V^2 L^3)
  double K_S = 500;                           ///< extensional stiffness Eh/((1-nu_s^2) rho_f V^2 L)
  double nu_s = 0.3;                          ///< Poisson ratio
  double damping = 0;                         ///< retardation time of the stretch (Kelvin-Voigt)
  std::array<double, 3> gravity = {0, 0, 0};  ///< body acceleration g L/V^2
  LeadingEdge leading_edge = LeadingEdge::pinned;
  std::optional<double> gamma;  ///< span S/L; none in two dimensions
};

struct FlowParameters {
  double Re = 0;  ///< Reynolds number V L/nu
  double U = 0;   ///< cross-flow U/V
};

/// What each parameter may be, wherever a case gives it: in [flag] and [flow], or along a sweep.
namespace ranges {
inline constexpr Range mu = positive;
inline constexpr Range Re = positive;
inline constexpr Range K_B = not_negative;
inline constexpr Range nu_s{0, 0.5};
inline constexpr Range gamma = positive;
inline constexpr Range U = any_sign;
inline constexpr Range k_x = any_sign;
inline constexpr Range k_y = positive;
}  // namespace ranges

void declare(Schema&, FlagParameters&);
void declare(Schema&, FlowParameters&, bool& is_given);

}  // namespace pennon

/// The added mass of a mode from the work of the pressure on it, (B 4) after Minami (1998):
///
///   c_m = - int int h_t Dp ds dx / int int h_tt h_t ds dx,
///
/// integrated by GSL. Dp is the force on the flag (below minus above): with the sign of (4.1),
/// above minus below, c_m would come out negative. For a mode h = Y(y) cos(k_x x) f(t) in still
/// fluid both integrands share the factor f' f'' cos^2(k_x x), which leaves c_m = int Y p dy / int
/// Y^2 dy with p the pressure jump that opposes a unit acceleration of the mode.
#pragma once

#include <functional>

namespace pennon::lsa {

/// The chordwise shape Y(y) of the mode.
enum class MinamiMode {
  plunge,        ///< 1
  pitch,         ///< y, about the leading edge
  sine,          ///< sin(k_y y)
  hanging_chain  ///< J_0(j_01 (1-y)^1/2)
};

/// How the fluid answers an acceleration of the flag.
enum class MinamiPressure {
  sheet,  ///< locally, as the unbounded sheet does: 2/(k_x^2 + k_y^2)^1/2; c_m is then `lamb`
  plate   ///< as potential flow around the chord 0 <= y <= 1 does: lsa/plate_pressure.hpp
};

struct MinamiSettings {
  MinamiMode mode = MinamiMode::sine;
  MinamiPressure pressure = MinamiPressure::plate;
};

/// c_m of the mode and pressure of the settings, to 1e-10. Precondition: k_y > 0. Throws
/// SolverError where GSL's quadrature does not reach its tolerance, or |k_x| or k_y is larger than
/// PlatePressure allows.
double minami(const MinamiSettings&, double k_x, double k_y);

/// (B 4) as it stands, for any fields over one span 0 <= x <= S and the chord 0 <= y <= 1 at one
/// time: the velocity h_t and acceleration h_tt of the flag and the pressure jump Dp, each a
/// function of (x, y). Throws SolverError where the quadrature does not converge or
/// the flag does no work on its own inertia (the denominator vanishes).
using FieldOnFlag = std::function<double(double x, double y)>;
double minami(const FieldOnFlag& h_t, const FieldOnFlag& h_tt, const FieldOnFlag& pressure_jump,
              double S);

}  // namespace pennon::lsa

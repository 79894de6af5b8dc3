/// The tension that the boundary layers of both faces leave in a flag in a stream.
#pragma once

#include <cmath>

namespace pennon::modes {

/// 1.3 is 2 x 0.664, the Blasius friction of both faces (Banerjee, Connell & Yue 2015, section 4).
inline constexpr double friction_of_both_faces = 1.3;

/// T_0 = 1.3 Re^-1/2, the chordwise tension at the leading edge, scaled by rho_f V^2 L.
/// Without a stream (Re = 0) there is none.
inline double leading_edge_tension(double Re) {
  return Re > 0 ? friction_of_both_faces / std::sqrt(Re) : 0;
}

}  // namespace pennon::modes

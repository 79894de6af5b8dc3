/// The tension that the boundary layers of both faces leave in a flag in a stream.
#pragma once

#include <cmath>

#include "common/boundary_layer.hpp"

namespace pennon::modes {

/// T_0 = 1.3 Re^-1/2, the chordwise tension at the leading edge, scaled by rho_f V^2 L.
/// Without a stream (Re = 0) there is none.
inline double leading_edge_tension(double Re) {
  return Re > 0 ? friction_of_both_faces / std::sqrt(Re) : 0;
}

}  // namespace pennon::modes

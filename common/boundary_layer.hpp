/// The friction of a laminar boundary layer, which leaves a tension in a flag in a stream.
#pragma once

namespace pennon {

/// Drag of both faces of a plate of chord L times Re^1/2, in rho_f V^2 L: 2 x 0.664 (Blasius 1908),
/// as Banerjee, Connell & Yue (2015) round it. The tension at the leading edge is this times
/// Re^-1/2.
inline constexpr double friction_of_both_faces = 1.3;

}  // namespace pennon

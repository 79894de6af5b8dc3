/// How the corners of the grid follow a small displacement of the flag along z: the elliptic grid
/// (dns/elliptic_grid.hpp), linearised about rest. Antisymmetric as the motion of the flag is:
/// along y odd in z, along z even.
#pragma once

#include <vector>

#include "modes/global/plane_equations.hpp"

namespace pennon::modes::global {

/// For each chordwise node of the flag from the leading edge, n_theta/2 + 1 of them, the corners'
/// displacement where this node alone is displaced, by 1.
std::vector<Displacement<double>> grid_response(const OGrid&);

}  // namespace pennon::modes::global

/// The flag on the wall of the O-grid: its chordwise nodes are the grid's corners there, and a
/// segment between two of them lies between two faces, one above and one below.
#pragma once

#include <vector>

#include "dns/grid/o_grid.hpp"

namespace pennon::dns {

/// The faces of the wall that a chordwise segment s of the flag lies between.
inline int upper_face(int n_theta, int s) {
  return n_theta / 2 - 1 - s;
}
inline int lower_face(int n_theta, int s) {
  return n_theta / 2 + s;
}

/// The chordwise nodes of a flag whose segments are the faces of the grid's wall.
std::vector<double> coupled_chord(const OGrid&);

}  // namespace pennon::dns

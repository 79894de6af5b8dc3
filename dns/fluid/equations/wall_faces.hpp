/// How the flag of a coupled simulation lies in the fluid's grid.
///
/// Along the chord, its nodes are the corners of the O-grid on the wall, and a segment between two
/// neighbouring nodes lies between two faces of the wall, one above and one below.
///
/// Along the span, the flag has stations (dns/flag/mesh.hpp), the spanwise positions of its nodes,
/// and the fluid has planes x = const (dns/grid/span.hpp). There are as many of one as of the
/// other, dns.n_x, and station m lies in plane m. Since all planes have the same chordwise grid,
/// what follows is that of any of them.
#pragma once

#include <vector>

#include "dns/grid/o_grid.hpp"

namespace pennon::dns {

/// The two faces of the wall, as numbers along theta, between which the chordwise segment s of the
/// flag lies; s counts from the leading edge.
inline int upper_face(int n_theta, int s) {
  return n_theta / 2 - 1 - s;
}
inline int lower_face(int n_theta, int s) {
  return n_theta / 2 + s;
}

/// The y of the chordwise nodes of a flag whose segments are the faces of the grid's wall:
/// n_theta/2 + 1 numbers from 0 to 1, in L.
std::vector<double> coupled_chord(const OGrid&);

}  // namespace pennon::dns

/// Fields without their ghosts, one row behind the other: as the solvers see them.
#pragma once

#include <algorithm>

#include "dns/grid/field.hpp"

namespace pennon::dns {

/// function(plane, j).
template <class Function>
void for_each_row(const Extent& extent, const Function& function) {
  for (int plane = 0; plane < extent.planes; ++plane)
    for (int j = 0; j < extent.n_rho; ++j) function(plane, j);
}

inline void pack(const Field<double>& f, double* packed) {
  for_each_row(f.extent(), [&](int plane, int j) {
    packed = std::copy_n(f.row(plane, j), f.extent().n_theta, packed);
  });
}

inline void unpack(const double* packed, Field<double>& f) {
  for_each_row(f.extent(), [&](int plane, int j) {
    std::copy_n(packed, f.extent().n_theta, f.row(plane, j));
    packed += f.extent().n_theta;
  });
}

}  // namespace pennon::dns

/// Values of the fluid at places (y, z) of a plane: a point is found on the moved grid and
/// interpolated between the four cell centres about it, linearly in the grid's coordinates. Second
/// order.
#pragma once

#include <optional>

#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/field.hpp"
#include "dns/grid/o_grid.hpp"

namespace pennon::dns {

/// Where a point lies among the cell centres: between j and j + 1, i and i + 1 (periodic).
struct GridPoint {
  int j = 0, i = 0;
  double s = 0, t = 0;  ///< 0 .. 1 between them

  double value(const Field<double>& f, int plane) const;
};

/// The point (y, z) of a plane, or nothing if it lies outside the outer boundary. Points nearer to
/// the flag than the first centre take its value.
std::optional<GridPoint> find_point(const OGrid&, const Displacement<double>&, int plane, double y,
                                    double z);

}  // namespace pennon::dns

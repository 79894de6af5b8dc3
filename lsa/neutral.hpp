/// Neutral curves: where a function of two parameters changes sign.
#pragma once

#include <functional>
#include <span>
#include <vector>

namespace pennon::lsa {

struct Polyline {
  std::vector<double> x, y;
};

/// Traces g(x, y) = 0 over a grid of nodes (increasing) by marching squares: every crossing of a
/// grid line is refined to the last bits of the coordinate along that line, so the polylines'
/// points lie on the curve to machine precision; only its course between them depends on the grid.
/// A closed curve ends where it begins. Cells with a NaN are left out. Throws what g throws.
std::vector<Polyline> trace_neutral(const std::function<double(double x, double y)>& g,
                                    std::span<const double> x, std::span<const double> y);

}  // namespace pennon::lsa

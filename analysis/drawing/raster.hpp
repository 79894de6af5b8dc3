/// A field on any rectangular grid, sampled on a raster of equally large pixels for a picture.
#pragma once

#include <cstddef>
#include <vector>

#include "analysis/drawing/figure.hpp"

namespace pennon::analysis {

struct Raster {
  std::size_t columns, rows;
  double x_low, x_high, y_low, y_high;  ///< the outer edges, in coordinates as drawn
  std::vector<double> values;           ///< rows of columns, the lowest row first
};

/// Samples the field at the pixels' centres, bilinearly in the coordinates as drawn; where a corner
/// of the cell is NaN, the value is that of the nearest node. Preconditions: the field has a value
/// for each pair of grid lines, and grid lines along a logarithmic axis are positive.
Raster raster(const FigureField&, const FigureAxis& x, const FigureAxis& y, std::size_t columns,
              std::size_t rows);

}  // namespace pennon::analysis

/// A field on any rectangular grid as a raster of equally large pixels, which is what a picture is.
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
/// of the cell is NaN, at its nearest node. Needs a value for each pair of grid lines, which must
/// be positive along a logarithmic axis.
Raster raster(const FigureField&, const FigureAxis& x, const FigureAxis& y, std::size_t columns,
              std::size_t rows);

}  // namespace pennon::analysis

/// The part of the plane a figure shows.
///
/// Coordinates "as drawn" are the values, or their decimal logarithms along a logarithmic axis.
#pragma once

#include "analysis/drawing/figure.hpp"

namespace pennon::analysis {

struct AxisRange {
  double low, high;
};

/// Both axes' ends, as drawn.
struct Frame {
  AxisRange x, y;
};

/// Whether an axis has a place for the value: it is finite, and positive where that is needed.
bool is_drawable(const FigureAxis&, double value);

/// The coordinate of a value as drawn.
double drawn(const FigureAxis&, double value);

/// The ends the axes prescribe, else those of all that is drawn: with a small margin, but none
/// around a field, which fills its frame.
Frame frame_of(const Figure&);

}  // namespace pennon::analysis

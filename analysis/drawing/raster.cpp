#include "analysis/drawing/raster.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "analysis/drawing/frame.hpp"

namespace pennon::analysis {
namespace {

// Where a pixel's centre lies between the grid lines: `fraction` of the way from `below` to
// `above`.
struct Place {
  std::size_t below, above;
  double fraction;
};

// A grid direction as drawn: its outer edges and the place of each pixel.
struct Direction {
  double low, high;
  std::vector<Place> places;
};

Direction direction(const std::vector<double>& lines, const FigureAxis& axis, std::size_t pixels) {
  assert(!lines.empty() && std::ranges::is_sorted(lines));
  std::vector<double> nodes;
  nodes.reserve(lines.size());
  for (const double line : lines) nodes.push_back(drawn(axis, line));
  Direction result{nodes.front(), nodes.back(), {}};
  if (result.low == result.high) {  // a single line is drawn as a band around it
    result.low -= 0.5;
    result.high += 0.5;
  }
  const double size = (result.high - result.low) / static_cast<double>(pixels);
  for (std::size_t i = 0; i < pixels; ++i) {
    const double center = result.low + (static_cast<double>(i) + 0.5) * size;
    const auto next = std::ranges::upper_bound(nodes, center) - nodes.begin();
    const auto above = std::min(static_cast<std::size_t>(next), nodes.size() - 1);
    const std::size_t below = above == 0 ? 0 : above - 1;
    const double width = nodes[above] - nodes[below];
    const double fraction = width > 0 ? std::clamp((center - nodes[below]) / width, 0.0, 1.0) : 0;
    result.places.push_back({below, above, fraction});
  }
  return result;
}

// Unlike std::lerp, which may return one end where the other is NaN.
double between(double a, double b, double fraction) {
  return (1 - fraction) * a + fraction * b;
}

double sample(const FigureField& field, const Place& x, const Place& y) {
  const auto at = [&](std::size_t column, std::size_t row) {
    return field.values[row * field.x.size() + column];
  };
  const double below = between(at(x.below, y.below), at(x.above, y.below), x.fraction);
  const double above = between(at(x.below, y.above), at(x.above, y.above), x.fraction);
  const double value = between(below, above, y.fraction);
  if (std::isfinite(value)) return value;
  return at(x.fraction < 0.5 ? x.below : x.above, y.fraction < 0.5 ? y.below : y.above);
}

}  // namespace

Raster raster(const FigureField& field, const FigureAxis& x_axis, const FigureAxis& y_axis,
              std::size_t columns, std::size_t rows) {
  assert(field.values.size() == field.x.size() * field.y.size());
  const Direction x = direction(field.x, x_axis, columns);
  const Direction y = direction(field.y, y_axis, rows);
  Raster result{columns, rows, x.low, x.high, y.low, y.high, {}};
  result.values.reserve(columns * rows);
  for (const Place& row : y.places)
    for (const Place& column : x.places) result.values.push_back(sample(field, column, row));
  return result;
}

}  // namespace pennon::analysis

#include "analysis/drawing/frame.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace pennon::analysis {
namespace {

// The hull of some values as drawn; empty (low > high) at first.
class Hull {
 public:
  explicit Hull(const FigureAxis& axis) : axis_(axis) {}
  void add(const std::vector<double>& values) {
    for (const double value : values) {
      if (!is_drawable(axis_, value)) continue;
      range_.low = std::min(range_.low, drawn(axis_, value));
      range_.high = std::max(range_.high, drawn(axis_, value));
    }
  }
  // The axis' ends as drawn: those it prescribes, else the hull with a margin.
  AxisRange ends(double margin) const {
    AxisRange range = range_;
    if (range.low > range.high) range = {0, 1};
    if (range.low == range.high) range = {range.low - half_width(), range.high + half_width()};
    const double extra = margin * (range.high - range.low);
    return {axis_.low ? drawn(axis_, *axis_.low) : range.low - extra,
            axis_.high ? drawn(axis_, *axis_.high) : range.high + extra};
  }

 private:
  double half_width() const {
    return axis_.is_log || range_.low == 0 ? 0.5 : 0.1 * std::abs(range_.low);
  }

  const FigureAxis& axis_;
  AxisRange range_{std::numeric_limits<double>::infinity(),
                   -std::numeric_limits<double>::infinity()};
};

}  // namespace

bool is_drawable(const FigureAxis& axis, double value) {
  constexpr double largest = 1e300;  // gnuplot takes 9e307 for infinite, and axes have margins
  return std::abs(value) < largest && !(axis.is_log && value <= 0);
}

double drawn(const FigureAxis& axis, double value) {
  return axis.is_log ? std::log10(value) : value;
}

Frame frame_of(const Figure& figure) {
  Hull x(figure.x);
  Hull y(figure.y);
  const auto add = [&](const auto& curve) {
    x.add(curve.x);
    y.add(curve.y);
  };
  if (figure.field) add(*figure.field);
  std::ranges::for_each(figure.lines, add);
  std::ranges::for_each(figure.marks, add);
  const double margin = figure.field ? 0 : 0.04;
  return {x.ends(margin), y.ends(margin)};
}

}  // namespace pennon::analysis

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
      span_.low = std::min(span_.low, drawn(axis_, value));
      span_.high = std::max(span_.high, drawn(axis_, value));
    }
  }
  // The axis' ends as drawn: those it prescribes, else the hull with a margin.
  Span ends(double margin) const {
    Span span = span_;
    if (span.low > span.high) span = {0, 1};
    if (span.low == span.high) span = {span.low - half_width(), span.high + half_width()};
    const double extra = margin * (span.high - span.low);
    return {axis_.low ? drawn(axis_, *axis_.low) : span.low - extra,
            axis_.high ? drawn(axis_, *axis_.high) : span.high + extra};
  }

 private:
  double half_width() const {
    return axis_.is_log || span_.low == 0 ? 0.5 : 0.1 * std::abs(span_.low);
  }

  const FigureAxis& axis_;
  Span span_{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
};

}  // namespace

bool is_drawable(const FigureAxis& axis, double value) {
  return std::isfinite(value) && !(axis.is_log && value <= 0);
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

#include "analysis/drawing/key_place.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pennon::analysis {
namespace {

// The size of text as fractions of the plot's area, roughly: what placing the key needs.
constexpr double letter_width = 0.0125;
constexpr double text_height = 0.055;
constexpr double sample_width = 0.13;

// The letters a label shows, without its markup.
std::size_t shown_length(const std::string& label) {
  std::size_t length = 0;
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (label.compare(i, 2, "{/") == 0)
      i = std::min(label.find_first_of(" }", i), label.size());
    else if (std::strchr("{}_^\\", label[i]) == nullptr)
      ++length;
  }
  return length;
}

class KeyPlace {
 public:
  KeyPlace(const Figure& figure, const Frame& frame) : figure_(figure), frame_(frame) {
    std::size_t longest = 0;
    const auto measure = [&](const auto& curve) {
      if (curve.label.empty()) return;
      rows_ += 1;
      longest = std::max(longest, shown_length(curve.label));
    };
    std::ranges::for_each(figure.lines, measure);
    std::ranges::for_each(figure.marks, measure);
    width_ = sample_width + letter_width * static_cast<double>(longest);
  }

  std::string text() const {
    if (rows_ == 0) return "unset key\n";
    const std::string form = "set key noautotitle Left reverse samplen 2.2 spacing 1.15 ";
    if (!figure_.field)
      for (const bool is_top : {true, false})
        for (const bool is_right : {true, false})
          if (is_free(is_right, is_top))
            return form + fmt::format("inside {} {}\n", is_top ? "top" : "bottom",
                                      is_right ? "right" : "left");
    // A title of one small blank keeps the key off the axis label.
    return form + "outside bottom center horizontal title ' ' font ',4'\n";
  }

 private:
  bool is_free(bool is_right, bool is_top) const {
    const double key_height = text_height * (static_cast<double>(rows_) + 0.5);
    const AxisRange x = is_right ? AxisRange{1 - width_, 1} : AxisRange{0, width_};
    const AxisRange y = is_top ? AxisRange{1 - key_height, 1} : AxisRange{0, key_height};
    const auto covers = [&](double u, double v) {
      return u >= x.low && u <= x.high && v >= y.low && v <= y.high;
    };
    const auto meets = [&](const auto& curve, bool is_joined) {
      for (std::size_t i = 0; i < curve.x.size(); ++i) {
        const double u = across(figure_.x, frame_.x, curve.x[i]);
        const double v = across(figure_.y, frame_.y, curve.y[i]);
        if (covers(u, v)) return true;
        if (is_joined && i > 0 && segment_meets(curve, i, u, v, covers)) return true;
      }
      return false;
    };
    return std::ranges::none_of(figure_.lines, [&](const Line& l) { return meets(l, true); }) &&
           std::ranges::none_of(figure_.marks, [&](const Marks& m) { return meets(m, false); });
  }

  // Walks from the point before the i-th, which is at (u, v), in steps shorter than the key.
  template <class Curve, class Covers>
  bool segment_meets(const Curve& curve, std::size_t i, double u, double v, Covers covers) const {
    const double u0 = across(figure_.x, frame_.x, curve.x[i - 1]);
    const double v0 = across(figure_.y, frame_.y, curve.y[i - 1]);
    const double length = std::max(std::abs(u - u0), std::abs(v - v0));
    if (!std::isfinite(length)) return false;
    constexpr double longest_step = 0.02;
    const int steps = static_cast<int>(std::min(length / longest_step, 1000.0));
    for (int step = 1; step < steps; ++step) {
      const double s = static_cast<double>(step) / steps;
      if (covers(std::lerp(u0, u, s), std::lerp(v0, v, s))) return true;
    }
    return false;
  }

  static double across(const FigureAxis& axis, const AxisRange& range, double value) {
    if (!is_drawable(axis, value)) return std::numeric_limits<double>::quiet_NaN();
    return (drawn(axis, value) - range.low) / (range.high - range.low);
  }

  const Figure& figure_;
  const Frame& frame_;
  std::size_t rows_ = 0;
  double width_ = 0;
};

}  // namespace

std::string key_command(const Figure& figure, const Frame& frame) {
  return KeyPlace(figure, frame).text();
}

}  // namespace pennon::analysis

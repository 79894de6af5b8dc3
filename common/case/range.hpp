/// A range: the interval of values that a number of the case file may have, and how to say so. The
/// values that a parameter takes in turn along an axis of a curve or map are a Sweep (sweep.hpp).
#pragma once

#include <string>

namespace pennon {

struct Range {
  double low;
  double high;

  /// Whether low <= value <= high; false for NaN and for infinities.
  bool contains(double value) const { return value >= low && value <= high; }
  /// "> 0 (1e-30 to 1e+30)", ">= 0 and <= 0.5", "of magnitude up to 1e+30".
  std::string text() const;
};

/// The largest magnitude a scaled parameter of a flag may have, and the smallest that one that must
/// be positive may have: far beyond any flag, yet products of a few of them neither overflow nor
/// lose digits to underflow.
inline constexpr double extreme = 1e30;
inline constexpr double smallest = 1e-30;

inline constexpr Range positive{smallest, extreme};
inline constexpr Range not_negative{0, extreme};
inline constexpr Range any_sign{-extreme, extreme};

}  // namespace pennon

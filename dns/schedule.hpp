/// When something that happens at intervals of time is due, and what rises in time.
#pragma once

#include <cmath>
#include <numbers>

namespace pennon::dns {

/// Whether a multiple of `interval` lies in (before, now]. An interval of 0: never.
inline bool passes_multiple(double interval, double before, double now) {
  if (interval <= 0) return false;
  constexpr double slack = 1e-9;  // of an interval, for times that are multiples but for rounding
  return std::floor(now / interval + slack) > std::floor(before / interval + slack);
}

/// From 0 at t = 0 to 1 at `duration`, with two continuous derivatives; duration 0: 1.
inline double smooth_rise(double t, double duration) {
  if (t >= duration) return 1;
  if (t <= 0) return 0;
  const double s = t / duration;
  return s - std::sin(2 * std::numbers::pi * s) / (2 * std::numbers::pi);
}

}  // namespace pennon::dns

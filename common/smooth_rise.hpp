/// What rises from nothing in a given time: the stream, the amplitude of a motion.
#pragma once

#include <cmath>
#include <numbers>

namespace pennon {

/// From 0 at t = 0 to 1 at `duration`, with two continuous derivatives; duration 0: 1.
inline double smooth_rise(double t, double duration) {
  if (t >= duration) return 1;
  if (t <= 0) return 0;
  const double s = t / duration;
  return s - std::sin(2 * std::numbers::pi * s) / (2 * std::numbers::pi);
}

}  // namespace pennon

/// When something that happens at intervals of time is due.
#pragma once

#include <cmath>

namespace pennon::dns {

/// Whether a multiple of `interval` lies in (before, now]. An interval of 0: never.
inline bool passes_multiple(double interval, double before, double now) {
  if (interval <= 0) return false;
  constexpr double slack = 1e-9;  // of an interval, for times that are multiples but for rounding
  return std::floor(now / interval + slack) > std::floor(before / interval + slack);
}

}  // namespace pennon::dns

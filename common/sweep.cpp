#include "common/sweep.hpp"

#include <cassert>
#include <cmath>

namespace pennon {

double Sweep::at(std::int64_t i) const {
  assert(i >= 0 && i < size());
  if (!list.empty()) return list[static_cast<std::size_t>(i)];
  if (i == 0) return from;
  if (i == points - 1) return to;
  const double fraction = static_cast<double>(i) / static_cast<double>(points - 1);
  if (scale == Scale::log) return from * std::exp(fraction * std::log(to / from));
  return from + fraction * (to - from);
}

std::vector<double> Sweep::values() const {
  std::vector<double> all(static_cast<std::size_t>(size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = at(static_cast<std::int64_t>(i));
  return all;
}

}  // namespace pennon

#include "common/case/sweep.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace pennon {

double Sweep::at(std::int64_t i) const {
  assert(i >= 0 && i < size());
  if (!list.empty()) return list[static_cast<std::size_t>(i)];
  if (i == 0) return from;
  if (i == points - 1) return to;
  const double fraction = static_cast<double>(i) / static_cast<double>(points - 1);
  const double value = scale == Scale::log ? from * std::exp(fraction * std::log(to / from))
                                           : from + fraction * (to - from);
  return std::clamp(value, from, to);  // roundoff may step over an end
}

bool Sweep::is_increasing() const {
  if (!list.empty()) return std::ranges::adjacent_find(list, std::greater_equal<>()) == list.end();
  return at(0) < at(1) && at(points - 2) < at(points - 1);
}

std::vector<double> Sweep::values() const {
  std::vector<double> all(static_cast<std::size_t>(size()));
  for (std::size_t i = 0; i < all.size(); ++i) all[i] = at(static_cast<std::int64_t>(i));
  return all;
}

}  // namespace pennon

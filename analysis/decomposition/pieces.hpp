/// The pieces of a flag that belong to its nodes: the weights of its shapes.
#pragma once

#include <optional>
#include <vector>

#include "analysis/decomposition/snapshots.hpp"

namespace pennon::decomposition {

/// Of nodes at y, increasing, at each station: from the middle to one neighbour to the middle to
/// the other, the first and the last from y itself, times the station's share of the span; station
/// by station. A single y has the length 1.
inline std::vector<double> flag_pieces(const std::vector<double>& y,
                                       const std::optional<Stations>& stations) {
  std::vector<double> of_station(y.size(), 1.0);
  if (y.size() > 1)
    for (std::size_t j = 0; j < y.size(); ++j) {
      const double below = j > 0 ? (y[j] - y[j - 1]) / 2 : 0;
      const double above = j + 1 < y.size() ? (y[j + 1] - y[j]) / 2 : 0;
      of_station[j] = below + above;
    }
  if (!stations) return of_station;
  std::vector<double> all;
  for (std::size_t i = 0; i < stations->count; ++i)
    for (const double length : of_station)
      all.push_back(length * stations->span / static_cast<double>(stations->count));
  return all;
}

}  // namespace pennon::decomposition

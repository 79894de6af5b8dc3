/// The nodes of a flag: their places, and the pieces of it that belong to them, the weights of its
/// shapes.
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

/// Says in the layout where the nodes at y are, at each of its stations.
inline void place_nodes(const std::vector<double>& y, Layout& layout) {
  const std::size_t stations = layout.stations ? layout.stations->count : 1;
  for (std::size_t i = 0; i < stations; ++i)
    for (const double at : y) {
      layout.y.push_back(at);
      if (layout.stations)
        layout.coordinates.push_back(layout.stations->span * static_cast<double>(i) /
                                     static_cast<double>(stations));
      layout.coordinates.push_back(at);
    }
  layout.dimensions = layout.stations ? 2 : 1;
}

}  // namespace pennon::decomposition

#include "modes/global/map/check_places.hpp"

#include <algorithm>

namespace pennon::modes::global {

std::vector<std::size_t> evenly_chosen(std::size_t size, std::size_t count) {
  std::vector<std::size_t> chosen;
  if (size <= count || count < 2) count = size;
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(count == 1 ? 0 : k * (size - 1) / (count - 1));
  return chosen;
}

std::optional<MapPlace> next_place(const MapModel& map, const std::vector<MapPlace>& places,
                                   const CheckedFit& fit) {
  const MapHeuristics& heuristics = map.task.settings.heuristics;
  const bool is_by_change = fit.checks.size() % 2 == 0;
  const Aerodynamics coarse = fit.coarse();
  std::optional<MapPlace> found;
  double largest = 0;
  for (const std::size_t k : evenly_chosen(places.size(), heuristics.candidates_for_check)) {
    const MapPlace& place = places[k];
    const FlagMode& mode = map.small_mode(place);
    double doubt = fit.distance_from_known(mode.lambda);
    if (is_by_change)
      doubt =
          std::min(doubt / heuristics.distance_of_news, 1.0) *
          std::abs(correction(coarse, map.small_flag(place.column), map.task.mu[place.m], mode));
    if (doubt <= largest) continue;
    largest = doubt;
    found = place;
  }
  return found;
}

}  // namespace pennon::modes::global

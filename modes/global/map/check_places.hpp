/// Where a map is checked.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "modes/global/map/map_model.hpp"

namespace pennon::modes::global {

/// `count` of the numbers 0 ... size - 1, equally far apart but for rounding, the first and the
/// last among them; all of them where there are no more than `count`.
std::vector<std::size_t> evenly_chosen(std::size_t size, std::size_t count);

/// The one of these places of a window at which the response is to be evaluated next; none where it
/// is known at all of them. Checks of two kinds alternate. One takes the place whose lambda is
/// farthest from every lambda at which the response is known. The other takes the place where a
/// coarser fit (CheckedFit::coarse) would change lambda most, and so the fit itself is most in
/// doubt.
std::optional<MapPlace> next_place(const MapModel&, const std::vector<MapPlace>& places,
                                   const CheckedFit&);

}  // namespace pennon::modes::global

#include "analysis/decomposition/times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/errors.hpp"

namespace pennon::decomposition {
namespace {

constexpr double unnoticed_shift = 1e-4;  // of a step
constexpr double longest_step = 1.9;      // of the median one

void expect_increasing(const std::vector<double>& t, const std::string& source) {
  for (std::size_t m = 0; m < t.size(); ++m) {
    if (!std::isfinite(t[m]))
      throw InputError(source,
                       fmt::format("has t = {} for snapshot {}; times must be finite", t[m], m));
    if (m > 0 && t[m] <= t[m - 1])
      throw InputError(source,
                       fmt::format("has t = {} for snapshot {}, not above {} before it; times "
                                   "must increase",
                                   t[m], m, t[m - 1]));
  }
}

}  // namespace

Selection selected(const std::vector<double>& t, const Window& window, const std::string& source) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  expect_increasing(t, source);
  const auto begin = std::ranges::lower_bound(t, window.from.value_or(-infinity));
  const auto end = std::ranges::upper_bound(t, window.to.value_or(infinity));
  const auto count = std::max<std::ptrdiff_t>(end - begin, 0);
  if (count >= 2)
    return {static_cast<std::size_t>(begin - t.begin()), static_cast<std::size_t>(count)};
  if (t.size() < 2)
    throw InputError(source, fmt::format("has {} snapshot{}; a decomposition needs two at least",
                                         t.size(), t.size() == 1 ? "" : "s"));
  throw InputError(source,
                   fmt::format("has {} snapshot{} from t = {} to {}, and {} from {} to {} "
                               "(decompose.from, decompose.to); a decomposition needs two",
                               t.size(), t.size() == 1 ? "" : "s", t.front(), t.back(), count,
                               window.from.value_or(t.front()), window.to.value_or(t.back())));
}

std::vector<double> taken_of(const std::vector<double>& values, Selection taken) {
  const auto begin = values.begin() + static_cast<std::ptrdiff_t>(taken.first);
  return {begin, begin + static_cast<std::ptrdiff_t>(taken.count)};
}

TimeGrid time_grid(const std::vector<double>& t, const std::string& source) {
  const std::size_t count = t.size();
  TimeGrid grid{(t.back() - t.front()) / static_cast<double>(count - 1), {}, 0, false};
  std::vector<double> steps;
  for (std::size_t m = 0; m < count; ++m) {
    grid.t.push_back(t.front() + static_cast<double>(m) * grid.dt);
    grid.largest_shift = std::max(grid.largest_shift, std::abs(t[m] - grid.t[m]) / grid.dt);
    if (m > 0) steps.push_back(t[m] - t[m - 1]);
  }
  grid.is_resampled = grid.largest_shift > unnoticed_shift;
  if (!grid.is_resampled) return grid;
  const auto longest = std::ranges::max_element(steps);
  const auto gap = static_cast<std::size_t>(longest - steps.begin());
  std::vector<double> sorted = steps;
  std::ranges::nth_element(sorted, sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2));
  const double median = sorted[sorted.size() / 2];
  if (count < 3 || *longest > longest_step * median)
    throw InputError(
        source, fmt::format("has a gap from t = {:.9g} to {:.9g}, {:.3g} times the median step of "
                            "{:.6g}; take the snapshots before or behind it with decompose.from "
                            "and decompose.to",
                            t[gap], t[gap + 1], *longest / median, median));
  return grid;
}

}  // namespace pennon::decomposition

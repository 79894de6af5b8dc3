/// The times of snapshots: which are taken, and whether their spacing serves.
///
/// Every method here counts each snapshot alike, and most need one time step. Times that differ
/// from equally spaced ones by no more than 1e-4 of the step are taken as equally spaced. Others
/// are resampled: each value to as many equally spaced times from the first to the last, by the
/// natural cubic spline through it, whose error is of the fourth order in the step. A step longer
/// than twice the median is a gap, across which nothing is known, and is refused.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace pennon::decomposition {

/// Of the snapshots that are taken: the first, and how many.
struct Selection {
  std::size_t first = 0, count = 0;
};

struct Window {
  std::optional<double> from, to;
};

/// The snapshots within a window. Throws InputError, which names the source, where the times do not
/// increase or are not finite, and where fewer than two snapshots are left.
Selection selected(const std::vector<double>& t, const Window&, const std::string& source);

/// Those of the times, or of other values of which each snapshot has one.
std::vector<double> taken_of(const std::vector<double>& values, Selection);

struct TimeGrid {
  double dt = 0;          ///< the one step
  std::vector<double> t;  ///< equally spaced
  /// The largest distance of a time from its equally spaced one, in steps.
  double largest_shift = 0;
  bool is_resampled = false;
};

/// Throws InputError where there is a gap: with its ends.
TimeGrid time_grid(const std::vector<double>& t, const std::string& source);

}  // namespace pennon::decomposition

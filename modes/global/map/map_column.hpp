/// The modes of a flag over a list of mass ratios, for one flow and one K: a column of a map of
/// growth rates. A mode that grows at some mass ratio and decays at another is neutral between
/// them; it is followed from there to larger and to smaller mass ratios.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "modes/global/neutral/flag_mode.hpp"

namespace pennon::modes::global {

/// The fluid's response in a window of the angular frequency.
struct ResponseInWindow {
  Interval omega;
  Aerodynamics F;
};

struct ColumnMode {
  std::size_t window;  ///< the one in which the mode is neutral
  FlagMode mode;
};

struct ColumnNeutral {
  std::size_t window;
  double omega, mu;
  Eigen::VectorXcd zeta;
};

struct MapColumn {
  /// For each mass ratio the mode with the largest growth rate, where there is a mode.
  std::vector<std::optional<ColumnMode>> leading;
  std::vector<ColumnNeutral> neutral;  ///< all neutral modes, by increasing mass ratio
};

using AcceptNeutral = std::function<bool(std::size_t window, const NeutralMode&)>;

/// `mu` increases. Neutral modes are sought with mass ratios in `mu_of_modes`. Where `known` is
/// given, the same column with a slightly different response, the search begins at its neutral
/// modes instead and covers the whole window only if one of them is not found again. Neutral modes
/// that are not accepted are dropped; the others are followed.
MapColumn map_column(const std::vector<ResponseInWindow>&, const FlagOperator& flag,
                     const std::vector<double>& mu, const Interval& mu_of_modes,
                     const AcceptNeutral& is_accepted, const MapColumn* known = nullptr);

}  // namespace pennon::modes::global

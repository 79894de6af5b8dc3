/// The modes of a flag over a list of mass ratios, for one flow and one K: a column of a map of
/// growth rates. Every mode that grows somewhere does so from some mass ratio on; it is followed
/// over mu from where it is neutral, up and down.
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
  std::size_t window;  ///< in which it is neutral
  FlagMode mode;
};

struct ColumnNeutral {
  std::size_t window;
  double omega, mu;
  Eigen::VectorXcd zeta;
};

struct MapColumn {
  /// For each mass ratio the mode that grows most, where there is one.
  std::vector<std::optional<ColumnMode>> most;
  std::vector<ColumnNeutral> neutral;  ///< all neutral modes, by their mass ratios
};

using AcceptNeutral = std::function<bool(std::size_t window, const NeutralMode&)>;

/// `mu`: increasing. `mu_of_modes`: neutral modes are sought there; or where they were in `known`,
/// the column with a slightly different response, as far as they are found again. Only those that
/// are accepted are followed.
MapColumn map_column(const std::vector<ResponseInWindow>&, const FlagOperator& flag,
                     const std::vector<double>& mu, const Interval& mu_of_modes,
                     const AcceptNeutral& is_accepted, const MapColumn* known = nullptr);

}  // namespace pennon::modes::global

#include "modes/global/map/map_column.hpp"

#include <algorithm>
#include <cmath>

namespace pennon::modes::global {
namespace {

// Follows modes over the mass ratios and keeps the one that leads at each.
class Tracer {
 public:
  Tracer(const ResponseInWindow& response, std::size_t window, const FlagOperator& flag,
         const std::vector<double>& mu, MapColumn& column)
      : F_(response.F), window_(window), flag_(flag), mu_(mu), column_(column) {}

  // Up and down from where the mode is neutral.
  void trace(const NeutralMode& neutral) {
    const FollowedMode start{neutral.mu,
                             {std::complex<double>(0, neutral.omega), neutral.zeta, neutral.by_mu}};
    const auto above =
        static_cast<std::size_t>(std::ranges::lower_bound(mu_, neutral.mu) - mu_.begin());
    before_.reset();
    last_ = start;
    for (std::size_t m = above; m < mu_.size() && step(m); ++m) {
    }
    before_.reset();
    last_ = start;
    for (std::size_t m = above; m-- > 0 && step(m);) {
    }
  }

 private:
  // Whether the mode was found there.
  bool step(std::size_t m) {
    auto mode = followed(F_, flag_, before_, last_, mu_[m]);
    if (!mode) return false;
    std::optional<ColumnMode>& leading = column_.leading[m];
    if (!leading || mode->lambda.real() > leading->mode.lambda.real()) leading = {window_, *mode};
    // A neutral mode next to this mass ratio is too near to tell how the curve bends.
    if (std::abs(last_.mu - mu_[m]) > nearest * mu_[m]) before_ = std::move(last_);
    last_ = {mu_[m], std::move(*mode)};
    return true;
  }

  static constexpr double nearest = 1e-3;

  const Aerodynamics& F_;
  std::size_t window_;
  const FlagOperator& flag_;
  const std::vector<double>& mu_;
  MapColumn& column_;
  std::optional<FollowedMode> before_;
  FollowedMode last_{};
};

// The neutral modes of the known column as they are with this response; none where one of them is
// not found again.
std::vector<NeutralMode> found_again(const ResponseInWindow& response, std::size_t window,
                                     const FlagOperator& flag, const MapColumn& known) {
  constexpr double same = 0.01;  // in omega, and relatively in mu
  std::vector<NeutralMode> found;
  for (const ColumnNeutral& before : known.neutral) {
    if (before.window != window) continue;
    auto mode = neutral_mode(response.F, flag, before.omega, before.mu);
    if (!mode || std::abs(mode->omega - before.omega) > same ||
        std::abs(mode->mu / before.mu - 1) > same)
      return {};
    found.push_back(std::move(*mode));
  }
  return found;
}

}  // namespace

MapColumn map_column(const std::vector<ResponseInWindow>& responses, const FlagOperator& flag,
                     const std::vector<double>& mu, const Interval& mu_of_modes,
                     const AcceptNeutral& is_accepted, const MapColumn* known) {
  MapColumn column;
  column.leading.resize(mu.size());
  for (std::size_t window = 0; window < responses.size(); ++window) {
    const ResponseInWindow& response = responses[window];
    std::vector<NeutralMode> neutral;
    if (known) neutral = found_again(response, window, flag, *known);
    if (neutral.empty()) neutral = neutral_modes(response.F, flag, response.omega, mu_of_modes);
    Tracer tracer(response, window, flag, mu, column);
    for (const NeutralMode& mode : neutral) {
      if (!is_accepted(window, mode)) continue;
      column.neutral.push_back({window, mode.omega, mode.mu, mode.zeta});
      tracer.trace(mode);
    }
  }
  std::ranges::sort(column.neutral, {}, &ColumnNeutral::mu);
  return column;
}

}  // namespace pennon::modes::global

#include "modes/normal/hanging_chain.hpp"

#include <algorithm>
#include <cmath>

#include "modes/normal/bessel_zero.hpp"
#include "modes/normal/tension.hpp"
#include "modes/normal/wave_panels.hpp"

namespace pennon::modes {
namespace {

// Where alpha sqrt(1 - y) has fallen by this share of alpha: the panels are narrower toward the
// trailing edge.
double y_at(double share) {
  const double root = 1 - share;
  return 1 - root * root;
}

}  // namespace

NormalModes hanging_chain_modes(const ModeRange& range, const FlagParameters& flag,
                                const FlowParameters& flow) {
  NormalModes result{Family::hanging_chain, flag.gamma, [](double) { return 1.0; }, {}, {}};
  const double T_0 = leading_edge_tension(flow.Re);
  const double T_x = flag.nu_s * T_0;
  double largest_alpha = 0;
  for (const int n : range.n)
    for (int m = 1; m <= range.m; ++m) {
      const double k_x = spanwise_wavenumber(n, flag);
      const double alpha = bessel_zero(0, m);
      largest_alpha = std::max(largest_alpha, alpha);
      const double slope = bessel_j(1, alpha);
      const double omega = std::sqrt((T_0 * alpha * alpha / 4 + T_x * k_x * k_x) / flag.mu);
      result.modes.push_back({n, m, k_x, alpha, omega, slope * slope, [alpha](double y) {
                                return bessel_j(0, alpha * std::sqrt(std::max(0.0, 1 - y)));
                              }});
    }
  result.panels = wave_panels(largest_alpha, y_at);
  return result;
}

}  // namespace pennon::modes

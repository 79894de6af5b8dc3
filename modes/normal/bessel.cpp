#include "modes/normal/bessel.hpp"

#include <algorithm>
#include <cmath>

#include "modes/normal/bessel_zero.hpp"
#include "modes/normal/tension.hpp"
#include "modes/normal/wave_panels.hpp"

namespace pennon::modes {

NormalModes bessel_modes(const ModeRange& range, const FlagParameters& flag,
                         const FlowParameters& flow) {
  NormalModes result{Family::bessel, flag.gamma, [](double y) { return 1 - y; }, {}, {}};
  const double c = std::sqrt(leading_edge_tension(flow.Re) / flag.mu);
  double largest_alpha = 0;
  for (const int n : range.n)
    for (int m = 1; m <= range.m; ++m) {
      const double alpha = bessel_zero(n, m);
      largest_alpha = std::max(largest_alpha, alpha);
      const double slope = bessel_j(n + 1, alpha);
      result.modes.push_back({n, m, spanwise_wavenumber(n, flag), alpha, c * alpha,
                              slope * slope / 2,
                              [n, alpha](double y) { return bessel_j(n, alpha * (1 - y)); }});
    }
  result.panels = wave_panels(largest_alpha, [](double share) { return share; });
  return result;
}

}  // namespace pennon::modes

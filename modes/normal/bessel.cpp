#include "modes/normal/bessel.hpp"

#include <algorithm>
#include <cmath>

#include "modes/normal/bessel_zero.hpp"
#include "modes/normal/tension.hpp"

namespace pennon::modes {
namespace {

// The quadrature integrates the product of two waves that turn by this much each to roundoff.
constexpr double radians_per_panel = 5;

std::vector<double> panels_for(double largest_alpha) {
  const auto count = static_cast<int>(std::ceil(largest_alpha / radians_per_panel)) + 1;
  std::vector<double> panels;
  for (int i = 0; i <= count; ++i) panels.push_back(static_cast<double>(i) / count);
  return panels;
}

}  // namespace

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
  result.panels = panels_for(largest_alpha);
  return result;
}

}  // namespace pennon::modes

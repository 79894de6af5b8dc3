/// Panels of the quadrature of normal modes that are waves along the chord.
#pragma once

#include <cmath>
#include <vector>

namespace pennon::modes {

/// The ends of the panels over 0 <= y <= 1, in each of which a wave of the largest phase `alpha`
/// turns by no more than 5 radians: the quadrature then integrates the product of two such waves to
/// roundoff. `y_at(share)` is the y at which a wave has passed this share of its phase; it
/// increases from 0 to 1.
template <class Function>
std::vector<double> wave_panels(double largest_alpha, const Function& y_at) {
  constexpr double radians_per_panel = 5;
  const auto count = static_cast<int>(std::ceil(largest_alpha / radians_per_panel)) + 1;
  std::vector<double> panels;
  for (int i = 0; i <= count; ++i) panels.push_back(y_at(static_cast<double>(i) / count));
  return panels;
}

}  // namespace pennon::modes

#include "modes/normal/initial_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "modes/normal/bessel_zero.hpp"

namespace pennon::modes {

InitialShape::InitialShape(std::vector<double> A, std::vector<double> B,
                           std::optional<double> gamma)
    : base_wavenumber_(gamma ? 2 * std::numbers::pi / *gamma : 0) {
  const std::size_t count = gamma ? std::max(A.size(), B.size()) : 1;
  A.resize(count);
  B.resize(count);
  for (std::size_t n = 0; n < count; ++n)
    waves_.push_back({A[n], B[n], bessel_zero(static_cast<int>(n), 1)});
}

double InitialShape::operator()(double x, double y) const {
  double zeta = 0;
  for (std::size_t n = 0; n < waves_.size(); ++n) {
    const auto& [A, B, alpha] = waves_[n];
    const double phase = base_wavenumber_ * static_cast<double>(n) * x;
    zeta += bessel_j(static_cast<int>(n), alpha * (1 - y)) *
            (A * std::cos(phase) + B * std::sin(phase));
  }
  return zeta;
}

}  // namespace pennon::modes

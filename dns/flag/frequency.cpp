#include "dns/flag/frequency.hpp"

#include <algorithm>
#include <cmath>

namespace pennon::dns {
namespace {

// Steps between the first two changes of sign; 0: there are no two.
std::size_t half_period(const std::vector<double>& z) {
  const auto changes = [](double before, double after) { return (before < 0) != (after < 0); };
  const auto first = std::ranges::adjacent_find(z, changes);
  if (first == z.end()) return 0;
  const auto second = std::adjacent_find(first + 1, z.end(), changes);
  return second == z.end() ? 0 : static_cast<std::size_t>(second - first);
}

}  // namespace

std::optional<double> angular_frequency(const std::vector<double>& z, double dt) {
  const std::size_t half = half_period(z);
  if (half == 0) return std::nullopt;
  const std::size_t k = std::max<std::size_t>(half / 2, 1);
  // Normal equations of z(t + k dt) = a z(t) + b z(t - k dt).
  double middle_middle = 0, middle_before = 0, before_before = 0, after_middle = 0,
         after_before = 0;
  for (std::size_t n = k; n + k < z.size(); ++n) {
    const double before = z[n - k];
    const double middle = z[n];
    const double after = z[n + k];
    middle_middle += middle * middle;
    middle_before += middle * before;
    before_before += before * before;
    after_middle += after * middle;
    after_before += after * before;
  }
  const double determinant = middle_middle * before_before - middle_before * middle_before;
  const double a = (after_middle * before_before - after_before * middle_before) / determinant;
  const double b = (after_before * middle_middle - after_middle * middle_before) / determinant;
  const double cosine = a / (2 * std::sqrt(-b));
  if (!(std::abs(cosine) < 1)) return std::nullopt;
  return std::acos(cosine) / (static_cast<double>(k) * dt);
}

}  // namespace pennon::dns

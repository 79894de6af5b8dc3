#include "modes/normal/bessel_zero.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_sf_bessel.h>

#include <cmath>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

constexpr double largest_correction = 1e-2;
// The first step squares GSL's relative error of 5e-9, the second only confirms.
constexpr int newton_steps = 2;

double first_guess(int n, int m) {
  const auto number = static_cast<unsigned>(m);
  gsl_sf_result zero{};
  const int status = n == 0   ? gsl_sf_bessel_zero_J0_e(number, &zero)
                     : n == 1 ? gsl_sf_bessel_zero_J1_e(number, &zero)
                              : gsl_sf_bessel_zero_Jnu_e(n, number, &zero);
  if (status != GSL_SUCCESS)
    throw SolverError(
        fmt::format("the zero {} of J_{} was not found: GSL says {}", m, n, gsl_strerror(status)));
  return zero.val;
}

}  // namespace

double bessel_j(int n, double x) {
  return ::jn(n, x);
}

double bessel_zero(int n, int m) {
  if (n < 0 || n > largest_n || m < 1 || m > largest_m)
    throw InputError("",
                     fmt::format("the zero m = {} of J_n with n = {} is not offered: n must be 0 "
                                 "to {}, m must be 1 to {}",
                                 m, n, largest_n, largest_m));
  const double guess = first_guess(n, m);
  double x = guess;
  for (int step = 0; step < newton_steps; ++step) {
    const double slope = n * bessel_j(n, x) / x - bessel_j(n + 1, x);
    x -= bessel_j(n, x) / slope;
  }
  if (!(std::abs(x - guess) < largest_correction))
    throw SolverError(
        fmt::format("the zero {} of J_{} was not found: Newton's method left GSL's {} "
                    "for {}",
                    m, n, guess, x));
  return x;
}

}  // namespace pennon::modes

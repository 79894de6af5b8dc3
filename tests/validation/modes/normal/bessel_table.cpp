/// Every zero that bessel_zero offers, n = 0 to 200 and m = 1 to 1000, against Boost.Math in
/// extended precision (which agrees with 50 digits to 2e-19 where that was sampled).
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <cstdio>

#include "modes/normal/bessel_zero.hpp"

namespace pennon::modes {
namespace {

constexpr double half_unit = 1.5e-16;

TEST(BesselZero, AgreesWithBoostOverTheWholeTable) {
  double worst = 0;
  int worst_n = 0;
  int worst_m = 0;
  for (int n = 0; n <= largest_n; ++n)
    for (int m = 1; m <= largest_m; ++m) {
      const auto exact = boost::math::cyl_bessel_j_zero<long double>(n, m);
      const auto error = static_cast<double>(std::abs(bessel_zero(n, m) / exact - 1));
      if (error <= worst) continue;
      worst = error;
      worst_n = n;
      worst_m = m;
    }
  std::printf("largest relative error %.3g at n = %d, m = %d\n", worst, worst_n, worst_m);
  EXPECT_LE(worst, half_unit) << "n = " << worst_n << ", m = " << worst_m;
}

}  // namespace
}  // namespace pennon::modes

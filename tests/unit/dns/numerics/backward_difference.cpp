/// Backward differences for steps of unequal length: exact for parabolas, the guess for lines.
#include "dns/numerics/backward_difference.hpp"

#include <gtest/gtest.h>

namespace pennon::dns {
namespace {

TEST(BackwardDifference, IsExactForParabolasAndItsGuessForLines) {
  constexpr double dt = 0.1;
  for (const double ratio : {0.6, 1.0, 1.2, 3.0}) {
    const double before = dt / ratio;
    const BackwardDifference D(dt, before);
    const auto parabola = [](double t) { return 0.3 - 2 * t + 5 * t * t; };
    EXPECT_NEAR(D.derivative(parabola(dt), parabola(0), parabola(-before)), -2 + 10 * dt, 1e-12)
        << ratio;
    const auto line = [](double t) { return 0.3 - 2 * t; };
    EXPECT_NEAR(D.guess_last * line(0) + D.guess_before * line(-before), line(dt), 1e-14) << ratio;
  }
}

TEST(BackwardDifference, OfTheFirstStepIsExactForLines) {
  const BackwardDifference D(0.1, 0);
  EXPECT_NEAR(D.derivative(0.5, 0.3, 77.0), 2, 1e-14);
  EXPECT_EQ(D.guess_last, 1);
  EXPECT_EQ(D.guess_before, 0);
}

}  // namespace
}  // namespace pennon::dns

/// The initial shape (5.1).
#include "modes/normal/initial_shape.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "modes/normal/bessel_zero.hpp"

namespace pennon::modes {
namespace {

constexpr double roundoff = 1e-15;

TEST(InitialShape, IsAtRestAtTheLeadingEdge) {
  const InitialShape shape({0.3, 0.1, 0.1}, {0, 0.1, -0.2}, 2.0);
  for (const double x : {0.0, 0.3, 1.1, 1.9}) EXPECT_NEAR(shape(x, 0), 0, roundoff);
}

TEST(InitialShape, RepeatsAlongTheSpanWithThePeriodGamma) {
  const InitialShape shape({0.3, 0.1, 0.1}, {0, 0.1, -0.2}, 2.0);
  EXPECT_NEAR(shape(0.7, 0.6), shape(2.7, 0.6), roundoff);
}

TEST(InitialShape, IsTheSumOfItsWaves) {
  const double gamma = 5;
  const InitialShape shape({0.2, 0, 0.1}, {0, 0.05}, gamma);
  const double x = 0.8;
  const double y = 0.35;
  const double phase = 2 * std::numbers::pi * x / gamma;
  const double sum = 0.2 * std::cyl_bessel_j(0, bessel_zero(0, 1) * (1 - y)) +
                     0.05 * std::cyl_bessel_j(1, bessel_zero(1, 1) * (1 - y)) * std::sin(phase) +
                     0.1 * std::cyl_bessel_j(2, bessel_zero(2, 1) * (1 - y)) * std::cos(2 * phase);
  EXPECT_NEAR(shape(x, y), sum, roundoff);
  EXPECT_EQ(shape.largest_wave(), 2);
}

TEST(InitialShape, InTwoDimensionsIsTheFirstWaveAlone) {
  const InitialShape plane({0.2, 7, 7}, {7, 7}, std::nullopt);
  EXPECT_NEAR(plane(0, 1), 0.2, roundoff);  // J_0(0) = 1
  EXPECT_EQ(plane(0.4, 0.5), plane(0, 0.5));
  EXPECT_EQ(plane.largest_wave(), 0);
}

TEST(InitialShape, WithMoreWavesThanThereAreZerosIsRefused) {
  EXPECT_THROW(InitialShape(std::vector<double>(largest_n + 2, 0.1), {}, 2.0), InputError);
}

}  // namespace
}  // namespace pennon::modes

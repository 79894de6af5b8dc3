/// The splines, their quadrature, and the graded elements they live on.
#include "modes/normal/spline_space.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "modes/normal/gauss_legendre.hpp"
#include "modes/normal/graded_breaks.hpp"

namespace pennon::modes {
namespace {

constexpr double roundoff = 1e-14;

TEST(SplineSpace, SumsToOneEverywhere) {
  const SplineSpace space(graded_breaks(20, 1e-6, 1e-2));
  for (const double y : {0.0, 1e-9, 1e-4, 0.3, 0.77, 1.0}) {
    const SplineSpace::Local local = space.at(y);
    EXPECT_NEAR(static_cast<double>(local.values.row(0).sum()), 1, roundoff) << "y = " << y;
    EXPECT_GE(local.first, 0);
    EXPECT_LE(local.first + SplineSpace::functions_per_element, space.size());
  }
}

TEST(SplineSpace, MovesAtAnEdgeWithOneFunctionAndTurnsWithTwo) {
  const SplineSpace space(graded_breaks(10, 1, 1));
  const auto at_0 = space.at(0).values;
  EXPECT_EQ(at_0(0, 0), 1);
  EXPECT_EQ(at_0.row(0).tail(SplineSpace::degree).abs().maxCoeff(), 0);
  EXPECT_NE(at_0(1, 1), 0);
  EXPECT_EQ(at_0.row(1).tail(SplineSpace::degree - 1).abs().maxCoeff(), 0);
  EXPECT_EQ(space.at(1).values(0, SplineSpace::degree), 1);
}

TEST(SplineSpace, HasTheDerivativesOfItsFunctions) {
  const SplineSpace space(graded_breaks(7, 1e-2, 1));
  const double step = 1e-5;
  const double y = 0.4;  // within an element, as are its neighbours
  const auto before = space.at(y - step).values;
  const auto here = space.at(y).values;
  const auto after = space.at(y + step).values;
  const auto largest = [](const auto& difference) {
    return static_cast<double>(difference.abs().maxCoeff());
  };
  // The error of a central difference, step^2/6 times the third (fourth) derivative; elements of
  // about 1/7 make that of the order of 8^3 7^3.
  const double tolerance = step * step * 1e6;
  EXPECT_LT(largest((after.row(0) - before.row(0)) / (2 * step) - here.row(1)), tolerance);
  EXPECT_LT(largest((after.row(1) - before.row(1)) / (2 * step) - here.row(2)), tolerance);
}

TEST(Quadrature, IsExactForSplineProductsTimesTheBlasiusTension) {
  // The integral of y^16 (1 - sqrt(y)) over [0.2, 0.9].
  const std::vector<double> panels = {0.2, 0.9};
  double sum = 0;
  for (const QuadraturePoint& point : gauss_legendre(panels))
    sum += point.weight * std::pow(point.y, 16) * (1 - std::sqrt(point.y));
  const auto primitive = [](double y) { return std::pow(y, 17) / 17 - std::pow(y, 17.5) / 17.5; };
  EXPECT_NEAR(sum / (primitive(0.9) - primitive(0.2)), 1, roundoff);
}

TEST(GradedBreaks, IncreaseFromZeroToOne) {
  for (const double layer : {1e-12, 1e-4, 0.1, 1.0}) {
    const std::vector<double> breaks = graded_breaks(50, layer, 1);
    ASSERT_EQ(breaks.size(), 51u);
    EXPECT_EQ(breaks.front(), 0);
    EXPECT_EQ(breaks.back(), 1);
    for (std::size_t i = 1; i < breaks.size(); ++i) EXPECT_LT(breaks[i - 1], breaks[i]);
    EXPECT_LT(breaks[1], 2 * layer) << "the layer is not resolved";
  }
}

TEST(GradedBreaks, WithTwiceTheElementsHoldTheSameBreaks) {
  const std::vector<double> coarse = graded_breaks(20, 1e-3, 1e-2);
  const std::vector<double> fine = graded_breaks(40, 1e-3, 1e-2);
  for (std::size_t i = 0; i < coarse.size(); ++i) EXPECT_NEAR(coarse[i], fine[2 * i], roundoff);
}

}  // namespace
}  // namespace pennon::modes

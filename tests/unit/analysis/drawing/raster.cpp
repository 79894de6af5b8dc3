/// A field on any grid as equally large pixels.
#include "analysis/drawing/raster.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pennon::analysis {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double roundoff = 1e-12;

// Grid lines that lie ever closer towards the first.
std::vector<double> graded_lines(double first, double last, std::size_t count) {
  std::vector<double> lines;
  for (std::size_t i = 0; i < count; ++i) {
    const double s = static_cast<double>(i) / static_cast<double>(count - 1);
    lines.push_back(first + (last - first) * s * s);
  }
  return lines;
}

template <class Function>
FigureField field_of(const std::vector<double>& x, const std::vector<double>& y, Function f) {
  FigureField field{x, y, {}, {}, false};
  for (const double v : y)
    for (const double u : x) field.values.push_back(f(u, v));
  return field;
}

TEST(Raster, IsExactForAPlaneInTheCoordinatesAsDrawn) {
  const FigureAxis linear;
  const FigureAxis log{"", true, {}, {}};
  const FigureField field =
      field_of(graded_lines(1e-3, 10, 23), graded_lines(-2, 5, 17),
               [](double x, double y) { return 3 * std::log10(x) - 2 * y + 1; });
  const Raster image = raster(field, log, linear, 91, 77);
  EXPECT_NEAR(image.x_low, -3, roundoff);
  EXPECT_NEAR(image.x_high, 1, roundoff);
  EXPECT_EQ(image.y_low, -2);
  EXPECT_EQ(image.y_high, 5);
  for (std::size_t row = 0; row < image.rows; ++row)
    for (std::size_t column = 0; column < image.columns; ++column) {
      const double x = -3 + 4 * (static_cast<double>(column) + 0.5) / 91;
      const double y = -2 + 7 * (static_cast<double>(row) + 0.5) / 77;
      ASSERT_NEAR(image.values[row * image.columns + column], 3 * x - 2 * y + 1, 10 * roundoff);
    }
}

TEST(Raster, LeavesBlankWhatIsNearestToANodeWithoutValue) {
  FigureField field = field_of({0, 1, 2}, {0, 1, 2}, [](double, double) { return 1.0; });
  field.values[4] = nan;
  const Raster image = raster(field, {}, {}, 200, 200);
  const auto blank =
      std::ranges::count_if(image.values, [](double value) { return std::isnan(value); });
  EXPECT_EQ(blank, 100 * 100);
  EXPECT_TRUE(std::isnan(image.values[100 * 200 + 100]));
  EXPECT_EQ(image.values.front(), 1);
}

TEST(Raster, DrawsASingleGridLineAsABand) {
  const Raster image =
      raster(field_of({3}, {0, 1}, [](double, double y) { return y; }), {}, {}, 4, 4);
  EXPECT_EQ(image.x_low, 2.5);
  EXPECT_EQ(image.x_high, 3.5);
  EXPECT_EQ(image.values[0], 0.125);
}

}  // namespace
}  // namespace pennon::analysis

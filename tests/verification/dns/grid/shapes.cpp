/// Shapes that the moving grid must follow from one jump: slopes to 2, travelling waves of
/// amplitude 0.2 and wavenumbers to 4 pi, large turns, shifts and arcs.
#include <gtest/gtest.h>

#include <functional>
#include <numbers>
#include <string>

#include "dns/grid/elliptic_grid.hpp"
#include "tests/support/grids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;
using Complex = std::complex<double>;

struct Shape {
  std::string name;
  int most_passes;  // that were needed on either grid, and a half more
  std::function<Complex(double)> at;
};

std::vector<Shape> shapes() {
  std::vector<Shape> all = {
      {"z = y^2", 20, [](double y) { return Complex(y, y * y); }},
      {"z = 2 y, of length 1", 20, [](double y) { return Complex(1, 2) / std::sqrt(5.0) * y; }},
      {"z = 2 y, sheared", 35, [](double y) { return Complex(y, 2 * y); }},
      {"heave by 1", 15, [](double y) { return Complex(y, 1); }}};
  for (const double degrees : {45.0, 63.0, 90.0})
    all.push_back({"turned by " + std::to_string(degrees), 25,
                   [=](double y) { return std::polar(y, degrees * pi / 180); }});
  for (const double arc : {2.0, 3.0})
    all.push_back({"an arc of " + std::to_string(arc), 30, [=](double y) {
                     return Complex(std::sin(arc * y), 1 - std::cos(arc * y)) / arc;
                   }});
  for (const double k : {1.0, 2.0, 4.0})
    for (const double phase : {0.0, 0.5, 1.0, 1.5}) {
      const std::string name =
          "sin " + std::to_string(k) + " pi y + " + std::to_string(phase) + " pi";
      all.push_back(
          {"0.2 y " + name,
           k < 2   ? 15
           : k < 4 ? 25
                   : 80,
           [=](double y) { return Complex(y, 0.2 * y * std::sin((k * y + phase) * pi)); }});
      all.push_back({"0.2 " + name,
                     k < 2   ? 15
                     : k < 4 ? 50
                             : 200,
                     [=](double y) { return Complex(y, 0.2 * std::sin((k * y + phase) * pi)); }});
    }
  return all;
}

void expect_followed(const OGrid& grid) {
  constexpr double tolerance = 1e-7;
  EllipticGrid elliptic(grid);
  for (const Shape& shape : shapes()) {
    const Wall wall = wall_of(grid, shape.at);
    Displacement<double> displacement(extent_of(grid));
    const EllipticGridSummary summary =
        elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, tolerance, 200);
    EXPECT_LE(summary.change, tolerance) << shape.name;
    EXPECT_LE(summary.passes, shape.most_passes) << shape.name;
    EXPECT_GT(summary.least_area, 0.2) << shape.name;
    for (int i = 0; i < grid.n_theta(); ++i) {
      ASSERT_DOUBLE_EQ(displacement.y.row(0, 0)[i], wall.y[static_cast<std::size_t>(i)]);
      ASSERT_DOUBLE_EQ(displacement.z.row(0, 0)[i], wall.z[static_cast<std::size_t>(i)]);
      ASSERT_EQ(displacement.y.row(0, grid.n_rho())[i], 0);
    }
  }
}

TEST(EllipticGrid, FollowsEveryShapeFromOneJump) {
  expect_followed(OGrid({60, 120, 8, 0.012, 0}));
}

TEST(EllipticGrid, FollowsEveryShapeFromOneJumpOnTwiceAsManyCells) {
  expect_followed(OGrid({120, 240, 8, 0.006, 0}));
}

TEST(EllipticGrid, FollowsEveryShapeWhereThetaIsClusteredTowardTheWake) {
  expect_followed(OGrid({60, 120, 8, 0.012, 0.4}));
}

}  // namespace
}  // namespace pennon::dns

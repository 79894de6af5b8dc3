/// The elliptic grid: what solves it, its order, how it is followed in time, folds.
#include "dns/grid/elliptic_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numbers>

#include "tests/support/grids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;
using Complex = std::complex<double>;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
const OGridSettings coarse{30, 60, 8, 0.024, 0};
const OGridSettings clustered{30, 60, 8, 0.024, 0.5};
const OGridSettings near{40, 80, 2, 0.02, 0};
const OGridSettings usual{60, 120, 8, 0.012, 0};

double largest_residual(const OGrid& grid, const Displacement<double>& displacement) {
  const std::ptrdiff_t corners = static_cast<std::ptrdiff_t>(grid.n_rho() - 1) * grid.n_theta();
  Eigen::VectorXd residual(2 * corners);
  EllipticGrid(grid).residual(0, displacement, residual.data(), residual.data() + corners);
  return residual.cwiseAbs().maxCoeff();
}

double distance(const Displacement<double>& a, const Displacement<double>& b) {
  double largest = 0;
  for (std::size_t k = 0; k < a.y.values().size(); ++k)
    largest = std::max(
        largest, std::hypot(a.y.values()[k] - b.y.values()[k], a.z.values()[k] - b.z.values()[k]));
  return largest;
}

Complex wave(double y, double t) {
  return {y, 0.1 * y * std::sin(2 * pi * (y - t))};
}

Displacement<double> solved(const OGrid& grid, const Wall& wall, double tolerance = 1e-10) {
  Displacement<double> displacement(extent_of(grid));
  EllipticGrid elliptic(grid);
  const EllipticGridSummary summary =
      elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, tolerance, 200);
  EXPECT_LE(summary.change, tolerance);
  EXPECT_GT(summary.least_area, 0);
  return displacement;
}

// The terms of the equation are as large as r itself; second differences divide by the least step
// squared, but of a displacement that vanishes, or is the same everywhere.
TEST(EllipticGrid, IsSatisfiedAtRestAndWhereAllIsDisplacedAlike) {
  for (const OGridSettings& settings : {coarse, clustered}) {
    const OGrid grid(settings);
    const double roundoff = 10 * epsilon * settings.R;
    EXPECT_LT(largest_residual(grid, Displacement<double>(extent_of(grid))), roundoff);
    const auto displaced = image_of(grid, [](Complex r) { return r; });
    EXPECT_LT(largest_residual(grid, displaced), roundoff);
    Displacement<double> alike(extent_of(grid));
    std::fill(alike.y.values().begin(), alike.y.values().end(), 0.7);
    std::fill(alike.z.values().begin(), alike.z.values().end(), -2.0);
    EXPECT_LT(largest_residual(grid, alike), roundoff);
  }
}

TEST(EllipticGrid, LeavesTheGridAtRestAlone) {
  const OGrid grid(coarse);
  EllipticGrid elliptic(grid);
  Displacement<double> displacement(extent_of(grid));
  const EllipticGridSummary summary = elliptic.relax(0, displacement, 1e-12, 10);
  EXPECT_EQ(summary.passes, 1);
  EXPECT_NEAR(summary.least_area, 1, 100 * epsilon);
  EXPECT_LT(distance(displacement, Displacement<double>(extent_of(grid))), 1e-12);
}

// Any conformal image of the conformal grid satisfies the differential equation: its differences do
// to second order.
void expect_second_order_residual(Complex (*image)(Complex)) {
  OGrid grid(near);
  double last = 0;
  for (int refinement = 0; refinement < 3; ++refinement) {
    const double found = largest_residual(grid, image_of(grid, image));
    if (refinement > 0) {
      const double order = std::log2(last / found);
      EXPECT_GT(order, 1.8);
      EXPECT_LT(order, 2.2);
    }
    last = found;
    grid = refined(grid);
  }
}

TEST(EllipticGrid, IsSatisfiedByTheGridTurned) {
  expect_second_order_residual([](Complex r) { return 0.5 + std::polar(1.0, 1.0) * (r - 0.5); });
}

TEST(EllipticGrid, IsSatisfiedByTheGridTurnedAndStretched) {
  expect_second_order_residual([](Complex r) { return std::polar(1.7, -0.4) * r + 0.3; });
}

TEST(EllipticGrid, IsSatisfiedByAnyConformalImage) {
  expect_second_order_residual([](Complex r) { return r + 0.02 * r * r; });
}

TEST(EllipticGrid, IsNotSatisfiedByAnImageThatIsNotConformal) {
  const OGrid grid(usual);
  EXPECT_GT(largest_residual(
                grid, image_of(grid, [](Complex r) { return Complex(r.real(), 0.9 * r.imag()); })),
            1e-2);
}

TEST(EllipticGrid, ConvergesAtSecondOrder) {
  std::vector<OGrid> grids = {OGrid(coarse)};
  std::vector<Displacement<double>> solutions;
  for (int refinement = 0; refinement < 3; ++refinement) {
    const OGrid& grid = grids.back();
    solutions.push_back(solved(grid, wall_of(grid, [](double y) { return wave(y, 0.2); })));
    grids.push_back(refined(grid));
  }
  const auto difference = [&](std::size_t k) {
    const Displacement<double>& fine = solutions[k + 1];
    double largest = 0, sum = 0;
    for (int j = 0; j <= grids[k].n_rho(); ++j)
      for (int i = 0; i < grids[k].n_theta(); ++i) {
        const std::ptrdiff_t at = 2 * static_cast<std::ptrdiff_t>(i);
        const double y = solutions[k].y.row(0, j)[i] - fine.y.row(0, 2 * j)[at];
        const double z = solutions[k].z.row(0, j)[i] - fine.z.row(0, 2 * j)[at];
        largest = std::max(largest, std::hypot(y, z));
        sum += std::hypot(y, z);
      }
    return std::pair(largest, sum / (grids[k].n_rho() * grids[k].n_theta()));
  };
  const auto [largest_before, mean_before] = difference(0);
  const auto [largest_behind, mean_behind] = difference(1);
  EXPECT_NEAR(std::log2(mean_before / mean_behind), 2, 0.2);
  EXPECT_NEAR(std::log2(largest_before / largest_behind), 2, 0.3);
}

TEST(EllipticGrid, ForgetsWhereItCameFrom) {
  const OGrid grid(coarse);
  const Wall wall = wall_of(grid, [](double y) { return wave(y, 0.2); });
  const Displacement<double> from_rest = solved(grid, wall);
  EllipticGrid elliptic(grid);
  Displacement<double> moved =
      solved(grid, wall_of(grid, [](double y) { return Complex(y, 0.3 * y * y); }));
  elliptic.follow(0, wall.y.data(), wall.z.data(), moved, 1e-10, 200);
  EXPECT_LT(distance(moved, from_rest), 1e-9);  // what a pass that changes 1e-10 may leave
}

TEST(EllipticGrid, IsTheSameAboveAndBelowForAFlagHeldUpsideDown) {
  const OGrid grid(coarse);
  const Displacement<double> up =
      solved(grid, wall_of(grid, [](double y) { return wave(y, 0.2); }));
  const Displacement<double> down =
      solved(grid, wall_of(grid, [](double y) { return std::conj(wave(y, 0.2)); }));
  for (int j = 0; j <= grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const int mirrored = (grid.n_theta() - i) % grid.n_theta();
      ASSERT_NEAR(up.y.row(0, j)[i], down.y.row(0, j)[mirrored], 1e-9);
      ASSERT_NEAR(up.z.row(0, j)[i], -down.z.row(0, j)[mirrored], 1e-9);
    }
}

// Extrapolated linearly in time, a wave is followed by so few passes a step.
TEST(EllipticGrid, FollowsAWaveSmoothlyInTime) {
  constexpr double dt = 1e-3;
  const OGrid grid(usual);
  EllipticGrid elliptic(grid);
  std::vector<Displacement<double>> history(4, Displacement<double>(extent_of(grid)));
  double largest_error = 0, roughest = 0;
  for (int n = 0; n < 40; ++n) {
    std::rotate(history.begin(), history.end() - 1, history.end());
    const Wall wall = wall_of(grid, [&](double y) { return wave(y, n * dt); });
    Displacement<double>& now = history[0];
    const Displacement<double>&last = history[1], &before = history[2], &earlier = history[3];
    if (n < 3) {
      now = solved(grid, wall);
      continue;
    }
    for (const auto component : {&Displacement<double>::y, &Displacement<double>::z})
      for (std::size_t k = 0; k < (now.*component).values().size(); ++k)
        (now.*component).values()[k] =
            2 * (last.*component).values()[k] - (before.*component).values()[k];
    const EllipticGridSummary summary =
        elliptic.follow(0, wall.y.data(), wall.z.data(), now, 1e-5, 20);
    EXPECT_LE(summary.passes, 2) << n;
    largest_error = std::max(largest_error, distance(now, solved(grid, wall)));
    for (std::size_t k = 0; k < now.z.values().size(); ++k)
      roughest = std::max(roughest, std::abs(now.z.values()[k] - 3 * last.z.values()[k] +
                                             3 * before.z.values()[k] - earlier.z.values()[k]));
  }
  EXPECT_LT(largest_error, 1e-6);
  // Of the wall's own third derivative, 0.1 (2 pi)^3; 7e4 times it before passes resolved the
  // residual in the frame of the grid.
  EXPECT_LT(roughest / (dt * dt * dt), 10 * 0.1 * std::pow(2 * pi, 3));
}

TEST(EllipticGrid, ContractsByTheAnisotropyOfTheGrid) {
  // Near the grid at rest q is small, and a pass all but solves.
  const OGrid grid(usual);
  EllipticGrid elliptic(grid);
  const Wall wall = wall_of(grid, [](double y) { return Complex(y, 0.01 * std::sin(3 * y)); });
  Displacement<double> displacement(extent_of(grid));
  elliptic.move_wall(0, wall.y.data(), wall.z.data(), displacement);
  const Displacement<double> solution = solved(grid, wall, 1e-12);
  for (int pass = 0; pass < 4; ++pass) {
    const double before = distance(displacement, solution);
    elliptic.relax(0, displacement, 0, 1);
    EXPECT_LT(distance(displacement, solution), 0.3 * before) << pass;
  }
}

// A fold is reported at the flag, as far as the flag was moved.
void expect_fold(const OGrid& grid, const Wall& wall) {
  EllipticGrid elliptic(grid);
  Displacement<double> displacement(extent_of(grid));
  const EllipticGridSummary summary =
      elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, 1e-6, 20);
  EXPECT_FALSE(summary.least_area > 0);
  double nearest = 1e300;
  for (int i = 0; i < grid.n_theta(); ++i) {
    const Complex corner(OGrid::place(0, grid.theta(i)).real() + displacement.y.row(0, 0)[i],
                         displacement.z.row(0, 0)[i]);
    nearest = std::min(nearest, std::abs(corner - Complex(summary.worst_y, summary.worst_z)));
  }
  EXPECT_LT(nearest, 0.1) << summary.worst_y << ", " << summary.worst_z << ": "
                          << summary.least_area;
}

TEST(EllipticGrid, ReportsAFoldWhereTheFlagCrossesItself) {
  const OGrid grid(coarse);
  constexpr double turn = 1.15 * 2 * pi;  // of an arc whose ends cross
  expect_fold(grid, wall_of(grid, [](double y) {
                return (std::polar(1.0, turn * y) - 1.0) / Complex(0, turn);
              }));
}

TEST(EllipticGrid, ReportsAFoldWhereTheFlagLeavesThroughTheOuterBoundary) {
  const OGrid grid(usual);
  expect_fold(grid, wall_of(grid, [](double y) { return Complex(y, 8.5); }));
}

TEST(EllipticGrid, ReportsWhatIsNotFinite) {
  const OGrid grid(coarse);
  Wall wall = wall_of(grid, [](double y) { return wave(y, 0); });
  wall.z[7] = std::numeric_limits<double>::quiet_NaN();
  EllipticGrid elliptic(grid);
  Displacement<double> displacement(extent_of(grid));
  const EllipticGridSummary summary =
      elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, 1e-6, 20);
  EXPECT_FALSE(summary.least_area > 0);
}

TEST(EllipticGrid, SaysNothingOfAWorstCellWhereNoneFolds) {
  const OGrid grid(coarse);
  const Wall wall = wall_of(grid, [](double y) { return wave(y, 0); });
  EllipticGrid elliptic(grid);
  Displacement<double> displacement(extent_of(grid));
  const EllipticGridSummary summary =
      elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, 1e-6, 50);
  EXPECT_EQ(summary.least_area, elliptic.least_area(0, displacement));
  EXPECT_EQ(summary.worst_y, 0);
  EXPECT_EQ(summary.worst_z, 0);
}

// Against the areas of the quadrilaterals by their corners.
TEST(EllipticGrid, SaysHowMuchThickerTheCellsAtTheFlagAre) {
  const OGrid grid(usual);
  const Wall wall =
      wall_of(grid, [](double y) { return Complex(y, 0.2 * y * std::sin(2 * pi * y)); });
  EllipticGrid elliptic(grid);
  Displacement<double> displacement(extent_of(grid));
  EXPECT_NEAR(elliptic.largest_wall_area(0, displacement), 1, 1e-12);
  elliptic.follow(0, wall.y.data(), wall.z.data(), displacement, 1e-6, 200);
  const auto area = [&](int i, bool is_moved) {
    double sum = 0;
    Complex before;
    constexpr std::array<std::array<int, 2>, 5> corners = {
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const auto [j, step] = corners[k];
      Complex corner = OGrid::place(grid.rho(j), grid.theta(i + step));
      if (is_moved)
        corner += Complex(displacement.y.row(0, j)[i + step], displacement.z.row(0, j)[i + step]);
      if (k > 0) sum += std::imag(std::conj(before) * corner) / 2;
      before = corner;
    }
    return sum;
  };
  double largest = 0;
  for (int i = 0; i < grid.n_theta(); ++i)
    largest = std::max(largest, area(i, true) / area(i, false));
  EXPECT_GT(largest, 1.5);
  EXPECT_NEAR(elliptic.largest_wall_area(0, displacement), largest, 1e-7 * largest);
}

}  // namespace
}  // namespace pennon::dns

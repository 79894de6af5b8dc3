/// The O-grid at rest: a conformal map with the flag's edges on corners.
#include "dns/grid/o_grid.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "common/errors.hpp"
#include "dns/fluid/equations/ghosts.hpp"
#include "tests/support/grids.hpp"

namespace pennon::dns {
namespace {

using std::numbers::pi;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double roundoff = 100 * epsilon;

const OGridSettings uniform{24, 32, 8, 0.03, 0};
const OGridSettings clustered{24, 32, 5, 0.03, 0.6};

TEST(OGrid, IsConformalWithTheStatedScale) {
  constexpr double h = 1e-5, difference_error = 1e-9;  // h^2/6 of the map's third derivative, and
                                                       // epsilon/h
  for (const double rho : {0.1, 0.7, 2.0})
    for (const double theta : {0.0, 0.4, 2.0, 5.0}) {
      const std::complex<double> along_rho =
          (OGrid::place(rho + h, theta) - OGrid::place(rho - h, theta)) / (2 * h);
      const std::complex<double> along_theta =
          (OGrid::place(rho, theta + h) - OGrid::place(rho, theta - h)) / (2 * h);
      EXPECT_LT(std::abs(along_rho - OGrid::slope(rho, theta)), difference_error);
      EXPECT_LT(std::abs(along_theta / std::complex(0.0, 1.0) - along_rho), difference_error);
      const double scale = (std::pow(std::sinh(rho), 2) + std::pow(std::sin(theta), 2)) / 4;
      EXPECT_NEAR(std::norm(OGrid::slope(rho, theta)), scale, roundoff * scale);
    }
}

TEST(OGrid, HasTheFlagForItsInnermostLineAndItsEdgesOnCorners) {
  for (const OGridSettings& settings : {uniform, clustered}) {
    const OGrid grid(settings);
    EXPECT_EQ(grid.rho(0), 0);
    EXPECT_EQ(OGrid::place(0, grid.theta(0)), 1.0);
    EXPECT_NEAR(grid.theta(grid.n_theta() / 2), pi, roundoff);
    EXPECT_LT(std::abs(OGrid::place(0, grid.theta(grid.n_theta() / 2))), roundoff);
    for (int i = 0; i <= grid.n_theta(); ++i)
      EXPECT_EQ(OGrid::place(0, grid.theta(i)).imag(), 0) << i;
  }
}

TEST(OGrid, EndsAtTheOuterRadius) {
  for (const OGridSettings& settings : {uniform, clustered}) {
    const OGrid grid(settings);
    const double R = settings.R;
    for (int i = 0; i < grid.n_theta(); ++i) {
      // An ellipse about the edges: its half axes are R and (R^2 + 1/4)^1/2.
      const double distance = std::abs(OGrid::place(grid.rho(grid.n_rho()), grid.theta(i)) - 0.5);
      EXPECT_GE(distance, R * (1 - roundoff));
      EXPECT_LE(distance, std::sqrt(R * R + 0.25) * (1 + roundoff));
    }
  }
}

TEST(OGrid, GrowsByOneRatioFromTheWallSpacing) {
  const OGrid grid(uniform);
  EXPECT_NEAR(grid.rho_step(0), uniform.wall_spacing, roundoff);
  for (int j = 1; j < grid.n_rho(); ++j)
    EXPECT_NEAR(grid.rho_step(j), grid.growth() * grid.rho_step(j - 1), roundoff) << j;
  EXPECT_GT(grid.growth(), 1);
}

TEST(OGrid, HasStepsThatSumUp) {
  for (const OGridSettings& settings : {uniform, clustered}) {
    const OGrid grid(settings);
    double rho = 0, theta = 0, theta_faces = 0;
    for (int j = 0; j < grid.n_rho(); ++j) rho += grid.rho_step(j);
    for (int i = 0; i < grid.n_theta(); ++i) {
      theta += grid.theta_step(i);
      theta_faces += grid.theta_face_step(i);
    }
    EXPECT_NEAR(rho, std::asinh(2 * settings.R), roundoff);
    EXPECT_NEAR(theta, 2 * pi, roundoff);
    EXPECT_NEAR(theta_faces, 2 * pi, roundoff);
    EXPECT_EQ(grid.theta_face_step(0), grid.theta_face_step(grid.n_theta()));
  }
}

TEST(OGrid, TakesTheWallStepAsTheGhostBehindTheWallDoes) {
  const OGrid grid(uniform);
  Field<double> rho(Extent{1, grid.n_rho(), grid.n_theta()});
  for (int j = 0; j < grid.n_rho(); ++j)
    std::fill_n(rho.row(0, j), grid.n_theta(), grid.rho_centre(j));
  const std::vector<double> wall(static_cast<std::size_t>(grid.n_theta()), 0.0);
  extend_to_wall(0, wall.data(), rho);
  EXPECT_NEAR(rho.row(0, 0)[0] - rho.row(0, -1)[0], grid.rho_face_step(0), roundoff);
}

TEST(OGrid, IsDenserAboutTheWakeWhereItIsClustered) {
  const OGrid grid(clustered);
  EXPECT_FALSE(grid.is_theta_uniform());
  const double mean = 2 * pi / grid.n_theta();
  EXPECT_LT(grid.theta_step(0), 0.5 * mean);
  EXPECT_GT(grid.theta_step(grid.n_theta() / 2), 1.5 * mean);
  for (int i = 0; i < grid.n_theta(); ++i)  // the same above and below
    EXPECT_NEAR(grid.theta_step(i), grid.theta_step(grid.n_theta() - 1 - i), roundoff) << i;
}

TEST(OGrid, HoldsTablesOfWhatItsFunctionsGive) {
  const OGrid grid(clustered);
  const RhoTable& rho = grid.along_rho();
  const ThetaTable& theta = grid.along_theta();
  ASSERT_EQ(rho.cosh.size(), 25u);
  ASSERT_EQ(rho.cosh_centre.size(), 24u);
  ASSERT_EQ(theta.cos.size(), 33u);
  ASSERT_EQ(theta.cos_centre.size(), 32u);
  for (const int j : {0, 5, 23}) {
    const auto at = static_cast<std::size_t>(j);
    EXPECT_EQ(2.0 * OGrid::slope(grid.rho(j), 0).real(), rho.sinh[at]);
    EXPECT_EQ(rho.cosh_centre[at], std::cosh(grid.rho_centre(j)));
    EXPECT_EQ(rho.sinh_half_step[at], std::sinh(grid.rho_step(j) / 2));
    EXPECT_EQ(rho.face_step[at], grid.rho_face_step(j));
  }
  for (const int i : {0, 7, 31}) {
    const auto at = static_cast<std::size_t>(i);
    EXPECT_EQ(theta.sin[at], std::sin(grid.theta(i)));
    EXPECT_EQ(theta.sin_centre[at], std::sin(grid.theta_centre(i)));
    EXPECT_EQ(theta.cos_half_step[at], std::cos(grid.theta_step(i) / 2));
    EXPECT_EQ(theta.face_step[at], grid.theta_face_step(i));
  }
}

TEST(OGrid, SaysInASentenceThatTheOuterRadiusCannotBeReached) {
  for (const double wall_spacing : {1e-12, 3.0}) {
    OGridSettings settings = uniform;
    settings.wall_spacing = wall_spacing;
    try {
      const OGrid grid(settings);
      FAIL() << "a wall spacing of " << wall_spacing << " was accepted";
    } catch (const InputError& error) {
      ASSERT_EQ(error.faults().size(), 1u);
      EXPECT_EQ(error.faults()[0].where, "dns.wall_spacing");
      EXPECT_NE(error.faults()[0].what.find("does not reach dns.R = 8"), std::string::npos);
      EXPECT_NE(error.faults()[0].what.find("dns.n_rho = 24"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace pennon::dns

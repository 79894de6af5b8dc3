// The drag of the plate along the stream over Re, grid, domain and step.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/fluids.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

struct Settings {
  int n_rho;
  double R, dt;
};
// First the usual one, then what changes one thing of it.
constexpr Settings usual{60, 8, 0.02};
constexpr Settings all[] = {usual,          {30, 8, 0.02}, {120, 8, 0.02}, {60, 16, 0.02},
                            {60, 32, 0.02}, {60, 8, 0.04}, {60, 8, 0.01},  {60, 8, 0.005}};

double blasius_drag(double Re) {
  return 2 * 1.328 / std::sqrt(Re);
}
double triple_deck_drag(double Re) {
  return blasius_drag(Re) + 2 * 2.67 * std::pow(Re, -7.0 / 8);
}

constexpr double steady = 40;

// Re, settings, C_D, C_D over the triple deck's, mid-chord friction over Blasius's.
std::vector<double> row(double Re, const Settings& settings) {
  FluidCase plate;
  plate.grid = {settings.n_rho, 2 * settings.n_rho, settings.R,
                24.0 / settings.n_rho / std::sqrt(Re), 0};
  plate.parameters = {Re, 0};
  FluidRun run(plate);
  run.run_to(steady, settings.dt);
  const double C_D = 2 * run.force()[1];
  const WallTraction traction = run.traction();
  const auto middle = static_cast<std::size_t>(settings.n_rho / 2);
  const double friction = -(traction.friction[middle - 1] + traction.friction[middle]) / 2;
  return {Re,
          static_cast<double>(settings.n_rho),
          2.0 * settings.n_rho,
          settings.R,
          plate.grid.wall_spacing,
          settings.dt,
          C_D,
          C_D / triple_deck_drag(Re),
          friction * std::sqrt(Re / 2) / 0.332};
}

// Above Blasius's, within 5 % of what the trailing edge makes of it, and converged in everything.
TEST(PlateDrag, IsThatOfTheTripleDeck) {
  std::vector<std::vector<double>> rows;
  for (const double Re : {100.0, 200.0, 500.0, 1000.0}) {
    std::vector<double> C_D;
    for (const Settings& settings : all) {
      rows.push_back(row(Re, settings));
      C_D.push_back(rows.back()[6]);
      EXPECT_GT(C_D.back(), blasius_drag(Re)) << Re;
      EXPECT_NEAR(C_D.back() / triple_deck_drag(Re), 1, 0.05) << Re;
    }
    // The grid: 30, 60, 120 cells. (The order is 2 at one step; the step's part differs.)
    EXPECT_LT(std::abs(C_D[2] - C_D[0]), 0.5 * std::abs(C_D[0] - C_D[1])) << Re;
    EXPECT_NEAR(C_D[2] / C_D[0], 1, 0.01) << Re;
    EXPECT_NEAR(C_D[3] / C_D[0], 1, 0.003) << Re;  // domain
    EXPECT_NEAR(C_D[4] / C_D[3], 1, 0.002) << Re;
    EXPECT_NEAR(C_D[7] / C_D[0], 1, 0.005) << Re;  // step
  }
  expect_reference(
      "fluid_plate_drag.csv",
      "plate at rest along the stream, impulsive start, t = 40; grid uniform in theta, "
      "Kawamura-Kuwahara; tests/validation/dns/fluid/plate_drag.cpp",
      {"Re", "n_rho", "n_theta", "R", "wall_spacing", "dt", "C_D", "C_D_over_triple_deck",
       "friction_at_mid_chord_over_Blasius"},
      rows, 1e-4);
}

}  // namespace
}  // namespace pennon::dns

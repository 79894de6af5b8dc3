// The global modes of the cases that the simulation is measured on: the simulation grows as they
// do. Kept under data/reference/pennon.
#include <gtest/gtest.h>

#include <array>
#include <complex>
#include <numbers>

#include "tests/support/global_growth.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon {
namespace {

using Complex = std::complex<double>;

struct GrowthCase {
  double mu, gamma;  // gamma = 0: two dimensions
  Complex near;      // the leading flutter mode
};

constexpr std::array<GrowthCase, 8> cases = {{{0.025, 0, {-0.497, 6.245}},
                                              {0.075, 0, {0.411, 5.545}},
                                              {0.125, 0, {0.974, 4.977}},
                                              {0.25, 0, {1.588, 3.866}},
                                              {0.075, 1, {-0.236, 5.650}},
                                              {0.125, 1, {0.133, 4.892}},
                                              {0.125, 2, {0.754, 4.846}},
                                              {0.125, 5, {0.942, 4.952}}}};

test::CoupledCase settings_of(const GrowthCase& the_case) {
  test::CoupledCase settings;
  settings.grid = {};  // 60 x 120
  settings.flag.mu = the_case.mu;
  settings.flag.nu_s = 0.3;
  settings.tolerances = {.pressure = 1e-12, .velocity = 1e-13, .grid = 1e-12};
  settings.coupling.tolerance = 1e-11;
  if (the_case.gamma > 0) {
    settings.planes = 4;
    settings.span = the_case.gamma;
  }
  return settings;
}

TEST(GlobalCases, TheSimulationGrowsAsTheGlobalMode) {
  constexpr double duration = 1.2;
  std::vector<std::vector<double>> rows;
  for (const GrowthCase& the_case : cases) {
    const test::CoupledCase settings = settings_of(the_case);
    const bool is_flat = the_case.gamma == 0;
    const double k_x = is_flat ? 0 : 2 * std::numbers::pi / the_case.gamma;
    for (const double dt : {0.004, 0.002, 0.001}) {
      const dns::FlowMode mode = test::mode_near(settings, k_x, dt, the_case.near);
      const Complex found = is_flat ? test::simulated<2>(settings, mode, dt, duration)
                                    : test::simulated<3>(settings, mode, dt, duration);
      const double difference = std::abs(found - mode.lambda) / std::abs(mode.lambda);
      rows.push_back({the_case.mu, the_case.gamma, dt, mode.lambda.real(), mode.lambda.imag(),
                      found.real(), found.imag(), difference});
      if (dt > 0.001) continue;
      EXPECT_LT(difference, 1e-3) << the_case.mu << ' ' << the_case.gamma;
      EXPECT_NEAR(found.real(), mode.lambda.real(), 0.01 * std::abs(mode.lambda.real()));
    }
    const auto of_step = [&](std::size_t from_last) {
      return rows[rows.size() - 1 - from_last].back();
    };
    EXPECT_LT(of_step(0), 0.31 * of_step(1)) << the_case.mu << ' ' << the_case.gamma;
    EXPECT_LT(of_step(1), 0.31 * of_step(2)) << the_case.mu << ' ' << the_case.gamma;
  }
  test::expect_reference(
      "global_growth.csv",
      "the leading flutter mode, and the simulation that starts as 1e-6 L of it over 1.2 L/V: "
      "growth rate and angular frequency; Re = 1000, K_B = 1e-4, K_S = 500, 60 x 120 cells, "
      "R = 8; gamma = 0: two dimensions, otherwise one wave along the span on 4 planes; "
      "difference: of lambda, relative; tests/validation/modes/global/cases.cpp",
      {"mu", "gamma", "dt", "sigma", "omega", "sigma_dns", "omega_dns", "difference"}, rows, 0.05);
}

}  // namespace
}  // namespace pennon

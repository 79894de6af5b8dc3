// The largest grid of two dimensions that is asked for.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

// 400 x 800 cells about a wave run as 100 x 200 do. So soon after an impulsive start the drag still
// depends on the step as seen by the smallest cells: it differs by 8 %.
TEST(LargeGrid, RunsAsASmallOneDoes) {
  double drag[2] = {};
  for (const int refined : {0, 1}) {
    const int n_rho = refined ? 400 : 100;
    FluidCase settings;
    settings.grid = {n_rho, 2 * n_rho, 8, 0.8 / n_rho, 0};
    settings.parameters = {1000, 0};
    FluidRun run(settings, [](double t, double, double y) -> std::array<double, 2> {
      return {0, 0.1 * y * std::sin(5 * y - 5 * t) * t * t};
    });
    run.run_to(0.2, 0.01);
    drag[refined] = 2 * run.force()[1];
    EXPECT_LE(run.most_pressure_iterations(), 20);
    EXPECT_GT(run.last().least_area, 0.2);
  }
  EXPECT_NEAR(drag[1] / drag[0], 1, 0.1);
}

}  // namespace
}  // namespace pennon::dns

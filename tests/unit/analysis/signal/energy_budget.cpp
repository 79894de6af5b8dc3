/// The coupled budget of energy from histories of which it is known.
#include "analysis/signal/energy_budget.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/smooth_rise.hpp"
#include "tests/support/synthetic_run.hpp"

namespace pennon::analysis {
namespace {

using test::set_column;
using test::synthetic_run;
using test::unequal_times;

// A flag that gains what the fluid gives it, in a stream with cross-flow 0.5: the fluid's energy
// grows by the drag's and side force's power less what dissipates and what goes to the flag.
RunHistory balanced_run() {
  RunHistory run = synthetic_run(unequal_times(5, 0.01), 1, 1, [](double, double) { return 0.0; });
  set_column(run, "C_D", [](double) { return 0.2; });
  set_column(run, "C_S", [](double) { return 0.08; });
  set_column(run, "dissipation", [](double) { return 0.03; });
  set_column(run, "outer_power", [](double) { return -0.01; });
  set_column(run, "fluid_work", [](double t) { return 0.02 * t; });
  set_column(run, "wall_power", [](double) { return 0.1 + 0.02 - 0.02; });
  set_column(run, "kinetic", [](double t) { return 0.1 + (0.1 - 0.03 - 0.01) * t; });
  set_column(run, "flag_kinetic", [](double t) { return 0.01 * t; });
  set_column(run, "bending", [](double t) { return 0.006 * t; });
  set_column(run, "damping_dissipated", [](double t) { return 0.004 * t; });
  return run;
}

TEST(EnergyBudget, OfABalancedRunHasNoDefect) {
  const EnergyBudget e = energy_budget(balanced_run(), {.U = 0.5});
  EXPECT_LT(e.residual, 1e-13);
  EXPECT_LT(e.residual_exchange, 1e-13);
  const std::size_t last = e.t.size() - 1;
  EXPECT_NEAR(e.total[last] - e.total[0] - e.received[last] + e.lost[last], 0, 1e-13);
  EXPECT_NEAR(e.flag[last], 0.016 * e.t[last], 1e-13);
}

TEST(EnergyBudget, CountsTheDefectsOfFluidFlagAndExchange) {
  RunHistory run = balanced_run();
  set_column(run, "energy_defect", [](double t) { return 0.01 * t; });
  set_column(run, "flag_defect", [](double t) { return -0.002 * t; });
  set_column(run, "fluid_work", [](double t) { return 0.023 * t; });
  const EnergyBudget e = energy_budget(run, {.U = 0.5});
  const double end = e.t.back(), kinetic = 0.1 + 0.06 * end + 0.01 * end;
  EXPECT_NEAR(e.residual, (0.01 - 0.002 + 0.003) * end / kinetic, 1e-12);
  EXPECT_NEAR(e.residual_exchange, 0.003 * end / kinetic, 1e-12);
}

TEST(EnergyBudget, TakesTheKickOutOfTheExchange) {
  RunHistory run = balanced_run();
  set_column(run, "fluid_work", [](double t) { return 0.02 * t + 0.5 * std::min(t / 0.1, 1.0); });
  EXPECT_GT(energy_budget(run, {.U = 0.5}).residual_exchange, 1);
  EXPECT_LT(energy_budget(run, {.U = 0.5, .kick_end = 0.1}).residual_exchange, 1e-12);
}

// While the stream rises, drag and side force work on what it has risen to.
TEST(EnergyBudget, FollowsTheStreamAsItRises) {
  RunHistory run = balanced_run();
  const double ramp = 5;
  set_column(run, "wall_power", [&](double t) { return 0.12 * smooth_rise(t, ramp) - 0.02; });
  EXPECT_GT(energy_budget(run, {.U = 0.5}).residual_exchange, 0.1);
  EXPECT_LT(energy_budget(run, {.U = 0.5, .ramp = ramp}).residual_exchange, 1e-6);
}

// A hanging flag's potential energy may be anything.
TEST(EnergyBudget, ComparesTheDefectWithTheEnergyWithoutGravity) {
  RunHistory run = balanced_run();
  set_column(run, "energy_defect", [](double t) { return 0.01 * t; });
  const double without = energy_budget(run, {.U = 0.5}).residual_per_time;
  set_column(run, "gravity", [&](double) { return -run.column("kinetic").front(); });
  EXPECT_NEAR(energy_budget(run, {.U = 0.5}).residual_per_time, without, 1e-12);
}

TEST(EnergyBudget, ChangesInAConvectivePeriod) {
  const std::vector<double> t = unequal_times(3, 0.01);
  std::vector<double> values, twos;
  for (const double time : t) {
    values.push_back(time * time);
    twos.push_back(2);
  }
  const std::vector<double> change = change_in_convective_period(t, values, twos);
  for (std::size_t row = 0; row < t.size(); ++row)
    if (t[row] < 1)
      EXPECT_TRUE(std::isnan(change[row]));
    else
      EXPECT_NEAR(change[row], (2 * t[row] - 1) / 2, 1e-4);
}

}  // namespace
}  // namespace pennon::analysis

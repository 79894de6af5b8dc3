/// How long the steps of a run are.
#include "dns/run/step_control.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace pennon::dns {
namespace {

TEST(EqualSteps, EndAtTheMultiplesOfTheStepAndAtTheEnd) {
  EqualSteps steps(0.25, 0.9);
  std::vector<double> times;
  for (; !steps.are_done(); steps.take()) times.push_back(steps.next_time());
  EXPECT_EQ(times, (std::vector<double>{0.25, 0.5, 0.75, 0.9}));
}

TEST(EqualSteps, AreNoMoreThanTheRunTakesUpToRounding) {
  EqualSteps steps(0.1, 0.3);  // 0.3/0.1 is less than 3 by rounding, 3 * 0.1 more than 0.3
  int count = 0;
  for (; !steps.are_done(); steps.take()) ++count;
  EXPECT_EQ(count, 3);
}

TEST(EqualSteps, GoOnAfterARestart) {
  EqualSteps steps(0.25, 1);
  steps.go_on(0, 3);
  EXPECT_EQ(steps.next_time(), 1);
  steps.take();
  EXPECT_TRUE(steps.are_done());
}

// All steps from 0, as the fluid takes them, with the Courant number that each has.
template <class CourantNumber>
std::vector<double> steps_taken(CourantSteps steps, const CourantNumber& CFL) {
  std::vector<double> taken;
  for (double t = 0; !steps.are_done(t); t += taken.back()) {
    taken.push_back(steps.next(t));
    steps.take(taken.back(), CFL(taken.back()));
  }
  return taken;
}

TEST(CourantSteps, GrowByAFifthFromASmallFirstStep) {
  CourantSteps steps(0.1, {}, 100);
  steps.go_on_with(0.01);
  const std::vector<double> taken = steps_taken(steps, [](double) { return 1.0; });
  for (std::size_t k = 1; k < 10; ++k) EXPECT_DOUBLE_EQ(taken[k], 1.2 * taken[k - 1]);
  EXPECT_EQ(taken[20], 0.1);
}

TEST(CourantSteps, KeepToTheCourantNumber) {
  constexpr double cells_per_length = 100, wanted = 2;
  const std::vector<double> taken =
      steps_taken(CourantSteps(0.1, wanted, 20), [](double dt) { return dt * cells_per_length; });
  EXPECT_EQ(taken[0], 0.1);
  EXPECT_DOUBLE_EQ(taken[1], 0.06) << "a step shrinks to 0.6 times the one before at most";
  EXPECT_DOUBLE_EQ(taken[20] * cells_per_length, wanted);
}

TEST(CourantSteps, ShareWhatIsLeftAtTheEnd) {
  constexpr double dt = 0.01, end = 1.004;
  const std::vector<double> taken =
      steps_taken(CourantSteps(dt, {}, end), [](double) { return 0.0; });
  double sum = 0;
  for (const double step : taken) {
    sum += step;
    EXPECT_GT(step, 0.98 * dt);
    EXPECT_LE(step, dt);
  }
  EXPECT_NEAR(sum, end, 1e-12);
}

}  // namespace
}  // namespace pennon::dns

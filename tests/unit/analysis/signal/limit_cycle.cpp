/// Limit cycles, phases and angles of waves from histories of which they are known.
#include "analysis/signal/limit_cycle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "analysis/signal/flapping_phases.hpp"
#include "analysis/signal/series.hpp"
#include "analysis/signal/travelling_wave.hpp"
#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/synthetic_run.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::analysis {
namespace {

using test::synthetic_run;
using test::two_pi;
using test::unequal_times;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double f = 0.87;

// With harmonics that shift neither extremes nor passages through zero unequally.
RunHistory flapping_run(double noise_size = 0) {
  test::Noise noise(noise_size);
  const double w = two_pi * f;
  RunHistory run = synthetic_run(unequal_times(22, 0.02), 1, 1, [&](double, double t) {
    return 0.02 + 0.13 * std::sin(w * t) + 0.01 * std::sin(3 * w * t) + noise();
  });
  test::set_column(run, "C_D", [&](double t) { return 0.14 + 0.05 * std::cos(2 * w * t); });
  test::set_column(run, "C_L", [&](double t) { return 0.01 + 0.1 * std::sin(w * t + 1); });
  return run;
}

TEST(LimitCycle, HasTheNumbersOfItsSinusoids) {
  const LimitCycleResult found = find_limit_cycle(flapping_run(), {});
  ASSERT_TRUE(found.cycle);
  // sin a - sin 3a: at the crest 0.13 - 0.01.
  EXPECT_NEAR(found.cycle->A_over_L, 0.12, 1e-4);
  EXPECT_NEAR(found.cycle->f_s, f, 1e-4);
  EXPECT_NEAR(found.cycle->St, 2 * 0.12 * f, 3e-4);
  EXPECT_NEAR(found.cycle->C_D_mean, 0.14, 1e-4);
  EXPECT_NEAR(found.cycle->C_L_amp, 0.1, 3e-4);
  EXPECT_EQ(found.cycle->periods.size(), 5U);
  EXPECT_GT(found.cycle->to, 22 - 1 / f - 0.1);
}

TEST(LimitCycle, IsFoundUnderNoise) {
  const LimitCycleResult found = find_limit_cycle(flapping_run(5e-4), {});
  ASSERT_TRUE(found.cycle);
  EXPECT_NEAR(found.cycle->A_over_L, 0.12, 0.003);
  EXPECT_NEAR(found.cycle->f_s, f, 0.002);
}

TEST(LimitCycle, CountsAPassageOnceUnderARipple) {
  const double w = two_pi * f;
  const RunHistory run = synthetic_run(unequal_times(22, 0.005), 1, 1, [&](double, double t) {
    return 0.1 * std::sin(w * t) + 0.015 * std::sin(41 * w * t);  // falls back below the mean
  });
  const LimitCycleResult found = find_limit_cycle(run, {});
  ASSERT_TRUE(found.cycle) << found.notes.front();
  EXPECT_NEAR(found.cycle->f_s, f, 1e-3);
}

TEST(LimitCycle, TakesAsManyPeriodsAsAskedFor) {
  Settings settings;
  settings.periods = 9;
  const LimitCycleResult found = find_limit_cycle(flapping_run(), settings);
  ASSERT_TRUE(found.cycle);
  EXPECT_EQ(found.cycle->periods.size(), 9U);
}

TEST(LimitCycle, IsTakenAtTheAntinode) {
  const RunHistory run = synthetic_run(unequal_times(20, 0.02), 2, 8, [](double x, double t) {
    return 0.1 * std::sin(two_pi * f * t) * (1 + 0.2 * std::cos(two_pi * (x - 0.75) / 2));
  });
  const LimitCycleResult found = find_limit_cycle(run, {});
  ASSERT_TRUE(found.cycle);
  EXPECT_EQ(found.cycle->antinode, 3U);
  EXPECT_NEAR(found.cycle->A_over_L, 0.12, 1e-4);
}

// Four planes resolve a wave whose antinodes lie between them.
TEST(LimitCycle, IsTakenBetweenTheStationsWhereTheAntinodeIsThere) {
  for (const std::size_t planes : {4U, 5U, 8U, 13U}) {
    const RunHistory run =
        synthetic_run(unequal_times(20, 0.02), 2, planes, [](double x, double t) {
          return 0.14 * std::sin(two_pi * f * t) * std::cos(two_pi * (x - 0.25) / 2);
        });
    const LimitCycleResult found = find_limit_cycle(run, {});
    ASSERT_TRUE(found.cycle);
    EXPECT_NEAR(found.cycle->A_over_L, 0.14, 3e-4) << planes;
    EXPECT_NEAR(std::fmod(found.cycle->antinode_share, 0.5), 0.125, 0.01) << planes;
  }
}

RunHistory sparse_run(double interval) {
  constexpr double mu = 0.1, amplitude = 0.14;
  const std::size_t rows = static_cast<std::size_t>(200 / interval);
  RunHistory run =
      synthetic_run(equal_times(0, interval * static_cast<double>(rows), rows + 1), 1, 1,
                    [](double, double t) { return amplitude * std::sin(two_pi * f * t); });
  // Of a flag whose deflection grows linearly to the trailing edge.
  test::set_column(run, "flag_kinetic", [](double t) {
    return mu / 6 * std::pow(two_pi * f * amplitude * std::cos(two_pi * f * t), 2);
  });
  return run;
}

TEST(LimitCycle, IsToldByEnoughRowsAPeriod) {
  constexpr double mu = 0.1;
  const LimitCycleResult enough = find_limit_cycle(sparse_run(0.1), {}, mu);
  ASSERT_TRUE(enough.cycle);
  EXPECT_NEAR(enough.cycle->f_s, f, 1e-3);
  EXPECT_NEAR(enough.cycle->A_over_L, 0.14, 1e-3);
  const LimitCycleResult few = find_limit_cycle(sparse_run(0.2), {}, mu);
  EXPECT_FALSE(few.cycle);
  EXPECT_THAT(few.notes, Contains(HasSubstr("rows a period, and 8 are needed; shorten "
                                            "dns.output.history_interval")));
}

// Every row is 1.1 L/V after the one before, in which the flag swings 0.957 times.
TEST(LimitCycle, IsNotAnAlias) {
  const LimitCycleResult blind = find_limit_cycle(sparse_run(1.1), {});
  ASSERT_TRUE(blind.cycle) << "the rows by themselves do not show it";
  EXPECT_NEAR(blind.cycle->f_s, 1 / 1.1 - f, 1e-3);
  const LimitCycleResult found = find_limit_cycle(sparse_run(1.1), {}, 0.1);
  EXPECT_FALSE(found.cycle);
  EXPECT_THAT(found.notes, Contains(HasSubstr("alias")));
}

TEST(LimitCycle, SaysWhereEveryOtherPeriodIsAnother) {
  const auto notes = [](double subharmonic, double phase) {
    const RunHistory run = synthetic_run(unequal_times(30, 0.02), 1, 1, [=](double, double t) {
      return 0.1 * std::sin(two_pi * f * t) + subharmonic * std::cos(two_pi * f * t / 2 + phase);
    });
    return find_limit_cycle(run, {}).notes;
  };
  for (const double phase : {0.0, 0.5, 1.0, 1.5}) {
    EXPECT_THAT(notes(0.05, phase), Contains(HasSubstr("limit cycle: ")));
    EXPECT_THAT(notes(0.03, phase), Contains(HasSubstr("limit cycle: "))) << phase;
    EXPECT_THAT(notes(0.001, phase), testing::Not(Contains(HasSubstr("limit cycle: "))));
  }
}

TEST(LimitCycle, SheddingIsThatOfTheNearestProbe) {
  RunHistory run = flapping_run();
  const auto swing = [](double frequency) {
    return [frequency](double, double t) { return std::sin(two_pi * frequency * t); };
  };
  test::add_probe(run, 3, 0.25, swing(2), swing(0.5));
  test::add_probe(run, 2, 0.2, swing(1.72), swing(0.86));
  const LimitCycleResult found = find_limit_cycle(run, {});
  ASSERT_TRUE(found.cycle && found.cycle->f_v);
  EXPECT_NEAR(*found.cycle->f_v, 0.86, 1e-4);
  Settings settings;
  settings.probe_y = 3.1;
  EXPECT_NEAR(*find_limit_cycle(run, settings).cycle->f_v, 0.5, 1e-4);
}

TEST(LimitCycle, WithoutAProbeSaysSo) {
  const LimitCycleResult found = find_limit_cycle(flapping_run(), {});
  ASSERT_TRUE(found.cycle);
  EXPECT_FALSE(found.cycle->f_v);
  EXPECT_THAT(found.notes, Contains(HasSubstr("no probe in the wake")));
}

std::string why_none(const test::Motion& z, double to = 20) {
  const LimitCycleResult found =
      find_limit_cycle(synthetic_run(unequal_times(to, 0.02), 1, 1, z), {});
  EXPECT_FALSE(found.cycle);
  return found.notes.empty() ? "" : found.notes.front();
}

TEST(LimitCycle, IsNoneWhileTheAmplitudeGrows) {
  EXPECT_THAT(why_none([](double, double t) {
                return 0.01 * std::exp(0.1 * t) * std::sin(two_pi * f * t);
              }),
              HasSubstr("% in amplitude"));
}

TEST(LimitCycle, IsNoneWhereTheFrequencyChanges) {
  EXPECT_THAT(
      why_none([](double, double t) { return 0.1 * std::sin(two_pi * t * (0.5 + t / 50)); }),
      HasSubstr("in length"));
}

TEST(LimitCycle, IsNoneOfAFlagAtRest) {
  EXPECT_THAT(why_none([](double, double t) { return 1e-4 * std::sin(two_pi * f * t); }),
              HasSubstr("at rest"));
}

TEST(LimitCycle, IsNoneOfARunOfTwoPeriods) {
  EXPECT_THAT(why_none([](double, double t) { return 0.1 * std::sin(two_pi * f * t); }, 2.6),
              HasSubstr("run longer"));
}

// zeta = A cos(k_x x + k_y (y - 1) - w t), seen at the trailing edge, in shapes and in a wake.
struct ObliqueWave {
  double gamma, k_y, direction;
  double k_x() const { return two_pi / gamma; }
  double operator()(double x, double y, double t) const {
    return std::cos(direction * k_x() * x + k_y * (y - 1) - two_pi * f * t);
  }
};

struct ObliqueRun {
  RunHistory run;
  test::TemporaryFolder folder;
  Angles angles(double U = 0.25) const {
    const LimitCycleResult found = find_limit_cycle(run, {});
    return find_angles(run, spanwise_components(run.z), found.cycle.value(), U, folder.path());
  }
};

void make_oblique(const ObliqueWave& flag, const ObliqueWave& wake, ObliqueRun& made) {
  made.run = synthetic_run(unequal_times(20, 0.02), flag.gamma, 8,
                           [&](double x, double t) { return 0.13 * flag(x, 1, t); });
  for (const double y : {2.0, 3.0})
    test::add_probe(
        made.run, y, 0.25, [](double, double) { return 0.0; },
        [&](double x, double t) { return 0.1 * wake(x, y, t); });
  test::write_shapes(
      equal_times(0, 20, 201), flag.gamma, 8, 21,
      [&](double x, double y, double t) { return 0.13 * y * flag(x, y, t); },
      made.folder / "shapes.h5");
}

class ObliqueAngles : public testing::TestWithParam<double> {};

TEST_P(ObliqueAngles, AreThoseOfTheCrests) {
  // theta = 20 degrees on the flag, and of a wake carried by the stream.
  const double k_x = two_pi / 2, direction = GetParam();
  const double k_flag = k_x / std::tan(20 * std::numbers::pi / 180);
  const double U = 0.75, k_wake = two_pi * f - direction * k_x * U;
  ObliqueRun made;
  make_oblique({2, k_flag, direction}, {2, k_wake, direction}, made);
  const Angles found = made.angles(U);
  ASSERT_TRUE(found.theta_s_deg && found.theta_v_deg);
  EXPECT_THAT(found.notes, IsEmpty());
  EXPECT_NEAR(*found.theta_s_deg, 20, 0.1);
  EXPECT_NEAR(*found.theta_v_deg, std::atan(k_x / k_wake) * 180 / std::numbers::pi, 0.1);
}

INSTANTIATE_TEST_SUITE_P(AlongAndAgainstX, ObliqueAngles, testing::Values(1.0, -1.0));

TEST(TravellingWave, WithoutShapesOrASecondProbeHasNoAngle) {
  ObliqueRun made;
  make_oblique({2, 6, 1}, {2, 6, 1}, made);
  std::filesystem::remove(made.folder / "shapes.h5");
  made.run.probes.pop_back();
  const Angles found = made.angles();
  EXPECT_FALSE(found.theta_s_deg);
  EXPECT_FALSE(found.theta_v_deg);
  EXPECT_THAT(found.notes, Contains(HasSubstr("dns.output.shape_interval")));
  EXPECT_THAT(found.notes, Contains(HasSubstr("no two probes")));
}

TEST(TravellingWave, WithFewShapesHasNoAngle) {
  ObliqueRun made;
  make_oblique({2, 6, 1}, {2, 6, 1}, made);
  test::write_shapes(
      equal_times(0, 20, 41), 2, 8, 21, [](double, double, double) { return 0.0; },
      made.folder / "shapes.h5");
  EXPECT_THAT(made.angles().notes, Contains(HasSubstr("shapes in 5 periods")));
}

TEST(TravellingWave, IsNotTakenFromShapesOfAnotherFlag) {
  ObliqueRun made;
  make_oblique({2, 6, 1}, {2, 6, 1}, made);
  test::write_shapes(
      equal_times(0, 20, 201), 2, 4, 21, [](double, double, double) { return 0.0; },
      made.folder / "shapes.h5");
  EXPECT_THAT(test::failure_of<InputError>([&] { made.angles(); }), HasSubstr("another span"));
}

TEST(TravellingWave, IsNoneWhereTheWaveStands) {
  ObliqueRun made;
  made.run = synthetic_run(unequal_times(20, 0.02), 2, 8, [](double x, double t) {
    return 0.13 * std::cos(two_pi * x / 2) * std::sin(two_pi * f * t);
  });
  EXPECT_THAT(made.angles().notes, Contains(HasSubstr("stands")));
}

TEST(TravellingWave, IsNoneWhereTheFlagIsTheSameAlongTheSpan) {
  ObliqueRun made;
  made.run = synthetic_run(unequal_times(20, 0.02), 2, 8,
                           [](double, double t) { return 0.13 * std::sin(two_pi * f * t); });
  EXPECT_THAT(made.angles().notes, Contains(HasSubstr("same along the span")));
}

TEST(SpanwiseComponents, AreThoseOfTheirWaves) {
  const std::vector<double> t = {0, 1};
  const RunHistory run = synthetic_run(t, 2, 12, [](double x, double) {
    return 0.3 - 0.2 * std::cos(two_pi * x / 2) + 0.1 * std::sin(3 * two_pi * x / 2);
  });
  const std::vector<std::vector<double>> sizes = moduli(spanwise_components(run.z));
  const std::vector<double> right = {0.3, 0.2, 0, 0.1, 0, 0, 0};
  ASSERT_EQ(sizes.size(), right.size());
  for (std::size_t n = 0; n < right.size(); ++n) EXPECT_NEAR(sizes[n][1], right[n], 1e-15) << n;
}

// Amplitudes that swing at twice the flapping frequency, as |zeta_n| do.
std::vector<double> swinging(const std::vector<double>& t,
                             const std::function<double(double)>& amplitude) {
  std::vector<double> values;
  values.reserve(t.size());
  for (const double time : t)
    values.push_back(amplitude(time) * std::abs(std::cos(two_pi * f * time)));
  return values;
}

double saturating(double t, double first, double last, double sigma) {
  return last / std::sqrt(1 + (std::pow(last / first, 2) - 1) * std::exp(-2 * sigma * t));
}

TEST(Phases, InTwoDimensionsAreGrowthAndSaturation) {
  const std::vector<double> t = unequal_times(40, 0.02);
  const Phases found =
      find_phases(t, {swinging(t, [](double s) { return saturating(s, 1e-3, 0.14, 0.5); })}, 1 / f);
  // (A_s/A)^2 - 1 = c exp(-2 sigma t): 3 at half the amplitude, 0.2346 at 0.9 of it; the envelope
  // sees half a period ahead.
  const double c = std::pow(140, 2) - 1;
  ASSERT_TRUE(found.I_end && found.II_end);
  EXPECT_NEAR(*found.I_end, std::log(c / 3), 0.5 / f);
  EXPECT_NEAR(*found.II_end, std::log(c / 0.2346), 0.5 / f);
  EXPECT_EQ(found.ruling, 0U);
}

TEST(Phases, OfAStandingWaveAreItsGrowthAndItsLossToTheTwoDimensionalMode) {
  const std::vector<double> t = unequal_times(40, 0.02);
  const auto share = [](double s) { return 1 / (1 + std::exp(-(s - 20))); };  // of n = 0
  const auto size = [](double s) { return saturating(s, 1e-3, 0.14, 1); };
  const Phases found =
      find_phases(t,
                  {swinging(t, [&](double s) { return size(s) * std::sqrt(share(s)); }),
                   swinging(t, [&](double s) { return size(s) * std::sqrt(1 - share(s)); })},
                  1 / f);
  const double c = std::pow(140, 2) - 1;
  ASSERT_TRUE(found.I_end && found.II_end);
  EXPECT_NEAR(*found.I_end, std::log(c / 3) / 2, 0.5 / f);
  EXPECT_NEAR(*found.II_end, 20 + std::log(9.0), 0.5 / f);
  EXPECT_EQ(found.ruling, 0U);
}

TEST(Phases, DoNotReachTheThirdWithTwoModes) {
  const std::vector<double> t = unequal_times(40, 0.02);
  const auto size = [](double s) { return saturating(s, 1e-3, 0.1, 1); };
  const Phases found = find_phases(
      t, {swinging(t, size), swinging(t, [&](double s) { return 0.7 * size(s); })}, 1 / f);
  EXPECT_TRUE(found.I_end);
  EXPECT_FALSE(found.II_end);
  EXPECT_THAT(found.notes, Contains(HasSubstr("does not hold 90 %")));
}

TEST(Phases, DoNotEndInARunThatStillGrows) {
  const std::vector<double> t = unequal_times(10, 0.02);
  const Phases found =
      find_phases(t, {swinging(t, [](double s) { return 1e-3 * std::exp(0.4 * s); })}, 1 / f);
  EXPECT_FALSE(found.I_end);
  EXPECT_FALSE(found.II_end);
  EXPECT_THAT(found.notes, Contains(HasSubstr("still grows")));
  EXPECT_THAT(found.notes, Contains(HasSubstr("phase III is not reached")));
}

TEST(Phases, AreNoneOfAFlagThatComesToRest) {
  const std::vector<double> t = unequal_times(20, 0.02);
  const Phases found =
      find_phases(t, {swinging(t, [](double s) { return 0.05 * std::exp(-s); })}, 1 / f);
  EXPECT_FALSE(found.I_end);
  EXPECT_FALSE(found.II_end);
  EXPECT_THAT(found.notes, Contains(HasSubstr("does not flap")));
}

TEST(Phases, HaveNoGrowthInARunThatStartsLarge) {
  const std::vector<double> t = unequal_times(20, 0.02);
  const Phases found = find_phases(t, {swinging(t, [](double) { return 0.14; })}, 1 / f);
  EXPECT_FALSE(found.I_end);
  EXPECT_THAT(found.notes, Contains(HasSubstr("I_end: the run has half")));
}

}  // namespace
}  // namespace pennon::analysis

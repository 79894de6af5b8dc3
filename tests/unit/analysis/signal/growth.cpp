/// Growth from histories of which it is known.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "analysis/signal/exponentials.hpp"
#include "analysis/signal/linear_phase.hpp"
#include "analysis/signal/series.hpp"
#include "tests/support/synthetic_run.hpp"

namespace pennon::analysis {
namespace {

using test::synthetic_run;
using test::unequal_times;
using testing::HasSubstr;
using testing::IsEmpty;

LinearPhase growth_of(const RunHistory& run, const Settings& settings = {}, double start = 0) {
  return find_linear_phase(run, spanwise_components(run.z), settings, start);
}

Complexes samples_of(const std::vector<Exponential>& sum, std::size_t count, double dt) {
  Complexes samples(count, 0.0);
  for (std::size_t k = 0; k < count; ++k)
    for (const Exponential& e : sum)
      samples[k] += e.amplitude * std::exp(e.lambda * (dt * static_cast<double>(k)));
  return samples;
}

TEST(Exponentials, AreFoundToRoundoff) {
  const std::vector<Exponential> sum = {{{0.3, 5.5}, {1, 0.5}},
                                        {{0.3, -5.5}, {1, -0.5}},
                                        {{-1.5, 9}, {0.2, 0}},
                                        {{-0.1, 0}, {0.05, 0}}};
  std::vector<Exponential> found = fit_exponentials(samples_of(sum, 120, 0.05), 0.05, 12);
  ASSERT_EQ(found.size(), sum.size());
  for (const Exponential& e : sum) {
    const auto same = std::ranges::min_element(
        found, {}, [&](const Exponential& f) { return std::abs(f.lambda - e.lambda); });
    EXPECT_LT(std::abs(same->lambda - e.lambda), 1e-8);
    EXPECT_LT(std::abs(same->amplitude - e.amplitude), 1e-8);
  }
}

TEST(Exponentials, AreNoneInASignalThatIsZero) {
  EXPECT_THAT(fit_exponentials(Complexes(30, 0.0), 0.1, 12), IsEmpty());
}

TEST(Exponentials, AreTwoInASinusoidUnderNoise) {
  test::Noise noise(0.01);
  Complexes samples = samples_of({{{0, 6}, 0.5}, {{0, -6}, 0.5}}, 160, 0.06);
  for (auto& sample : samples) sample += noise();
  const std::vector<Exponential> found = fit_exponentials(samples, 0.06, 12);
  ASSERT_EQ(found.size(), 2U);
  // The error of a frequency in white noise, sqrt(6) noise/(amplitude dt N^(3/2)): 0.0002.
  EXPECT_NEAR(std::abs(found[0].lambda.imag()), 6, 0.002);
}

// A growing sinusoid of which the first row has the amplitude `first`.
double growing(double t, double first, double sigma, double omega) {
  return first * std::exp(sigma * t) * std::cos(omega * t + 0.4);
}

// Most of a long run of a stable flag is the noise of its tolerances.
TEST(Growth, OfAFlagThatComesToRestIsFoundBeforeItsNoise) {
  test::Noise noise(1e-6);
  const RunHistory run = synthetic_run(unequal_times(40, 0.01), 1, 1, [&](double, double t) {
    return growing(t, 0.01, -0.51, 6.26) + noise();
  });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, -0.51, 0.005);
  EXPECT_NEAR(found.growth->omega, 6.26, 0.005);
}

TEST(Growth, OfASinusoidOnUnequalRowsIsFound) {
  const RunHistory run = synthetic_run(
      unequal_times(14, 0.02), 1, 1, [](double, double t) { return growing(t, 1e-4, 0.35, 5.4); });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, 0.35, 1e-4);
  EXPECT_NEAR(found.growth->omega, 5.4, 1e-4);
  EXPECT_NEAR(found.growth->amplitude, 1e-4 * std::exp(0.35 * found.growth->from),
              0.01 * found.growth->amplitude);
}

TEST(Growth, IsNotBiasedByATransientAnOffsetAndNoise) {
  test::Noise noise(2e-5);
  const RunHistory run = synthetic_run(unequal_times(14, 0.02), 1, 1, [&](double, double t) {
    return growing(t, 4e-4, 0.3, 5.4) + 4e-3 * std::exp(-1.5 * t) * std::cos(8 * t) + 2e-4 +
           noise();
  });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, 0.3, 0.01);
  EXPECT_NEAR(found.growth->omega, 5.4, 0.01);
  EXPECT_LE(std::abs(found.growth->sigma - 0.3), 3 * found.growth->sigma_error);
  EXPECT_LT(found.growth->sigma_error, 0.03);
}

// Stuart's and Landau's equation: |A|^2 = saturated^2/(1 + c exp(-2 sigma t)).
double saturating(double t, double first, double saturated, double sigma, double omega) {
  const double c = std::pow(saturated / first, 2) - 1;
  return saturated / std::sqrt(1 + c * std::exp(-2 * sigma * t)) * std::cos(omega * t);
}

// A flag that hangs or is blown to one side grows or decays about where it is.
TEST(Growth, IsFoundAboutADeflectedFlag) {
  for (const double offset : {0.05, 0.2, -0.4}) {
    const RunHistory grows = synthetic_run(unequal_times(14, 0.02), 1, 1, [&](double, double t) {
      return offset + growing(t, 1e-4, 0.35, 5.4);
    });
    const LinearPhase found = growth_of(grows);
    ASSERT_TRUE(found.growth) << offset << found.note;
    EXPECT_NEAR(found.growth->sigma, 0.35, 1e-3) << offset;
    EXPECT_NEAR(found.growth->omega, 5.4, 1e-3) << offset;
    if (offset != 0.2) continue;
    const RunHistory decays = synthetic_run(unequal_times(14, 0.02), 1, 1, [&](double, double t) {
      return offset + growing(t, 0.1, -0.3, 5.4);
    });
    const LinearPhase faded = growth_of(decays);
    ASSERT_TRUE(faded.growth) << offset << faded.note;
    EXPECT_NEAR(faded.growth->sigma, -0.3, 1e-3) << offset;
  }
}

TEST(Growth, EndsWhereItSaturates) {
  const RunHistory run = synthetic_run(unequal_times(40, 0.02), 1, 1, [](double, double t) {
    return saturating(t, 1e-4, 0.14, 0.4, 5.5);
  });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, 0.4, 0.01);
  EXPECT_NEAR(found.growth->omega, 5.5, 0.01);
  EXPECT_LT(found.growth->to, 20);  // 0.14 exp(-0.4 (t_s - t)) reaches 0.06 at 16
}

TEST(Growth, IsNegativeInADecayingRun) {
  const RunHistory run = synthetic_run(unequal_times(20, 0.02), 1, 1,
                                       [](double, double t) { return growing(t, 0.04, -0.5, 4); });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, -0.5, 1e-3);
  EXPECT_NEAR(found.growth->omega, 4, 1e-3);
}

TEST(Growth, IsThatOfTheLeadingWaveAlongTheSpan) {
  const double k = test::two_pi / 2;
  const RunHistory run = synthetic_run(unequal_times(12, 0.02), 2, 8, [&](double x, double t) {
    return growing(t, 3e-4, 0.25, 5) * std::cos(2 * k * x + 0.3) +
           growing(t, 1e-4, -0.1, 6) * std::sin(k * x);
  });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_EQ(found.wave, 2U);
  EXPECT_NEAR(found.growth->sigma, 0.25, 1e-3);
  EXPECT_NEAR(found.growth->omega, 5, 1e-3);
}

TEST(Growth, OfTwoWavesTravellingOpposedIsThatOfTheFaster) {
  const double k = test::two_pi;
  const RunHistory run = synthetic_run(unequal_times(12, 0.02), 1, 8, [&](double x, double t) {
    return 2e-4 * std::exp(0.4 * t) * std::cos(k * x - 6 * t) +
           2e-4 * std::exp(0.1 * t) * std::cos(k * x + 4 * t);
  });
  const LinearPhase found = growth_of(run);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, 0.4, 2e-3);
  EXPECT_NEAR(found.growth->omega, 6, 2e-3);
}

TEST(Growth, IsTakenInTheWindowThatTheUserGives) {
  const RunHistory run = synthetic_run(unequal_times(16, 0.02), 1, 1, [](double, double t) {
    return t < 8 ? growing(t, 1e-3, 0.3, 5) : growing(t, 0.2, -0.1, 5);
  });
  Settings settings;
  settings.from = 9;
  settings.to = 15;
  const LinearPhase found = growth_of(run, settings);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_NEAR(found.growth->sigma, -0.1, 1e-3);
  EXPECT_EQ(found.growth->from, 9);
  EXPECT_EQ(found.growth->to, 15);
}

TEST(Growth, IsSoughtAfterTheFlagIsReleased) {
  const RunHistory run = synthetic_run(unequal_times(14, 0.02), 1, 1, [](double, double t) {
    return t < 4 ? 1e-3 : growing(t - 4, 1e-3 / std::cos(0.4), 0.35, 5.4);
  });
  const LinearPhase found = growth_of(run, {}, 4);
  ASSERT_TRUE(found.growth) << found.note;
  EXPECT_GE(found.growth->from, 4);
  EXPECT_NEAR(found.growth->sigma, 0.35, 1e-3);
  EXPECT_NEAR(found.growth->omega, 5.4, 1e-3);
}

TEST(Growth, IsNotToldOfARunThatNeverIsSmall) {
  const RunHistory run = synthetic_run(unequal_times(16, 0.02), 1, 1,
                                       [](double, double t) { return 0.15 * std::cos(5 * t); });
  const LinearPhase found = growth_of(run);
  EXPECT_FALSE(found.growth);
  EXPECT_THAT(found.note, HasSubstr("--from"));
}

TEST(Growth, IsNotToldOfThreeModesOfWhichNoneLeads) {
  const RunHistory run = synthetic_run(unequal_times(16, 0.02), 1, 1, [](double, double t) {
    return 0.01 * (std::cos(4 * t) + std::cos(5.5 * t) + std::cos(7.3 * t));
  });
  EXPECT_FALSE(growth_of(run).growth);
}

TEST(Growth, IsNotToldWhereTheFrequencyKeepsRising) {
  const RunHistory run = synthetic_run(unequal_times(8, 0.01), 1, 1, [](double, double t) {
    return 0.005 * std::cos(2 * std::exp(0.6 * t));
  });
  const LinearPhase found = growth_of(run);
  EXPECT_FALSE(found.growth);
  EXPECT_THAT(found.note, HasSubstr("no window with a single exponential"));
}

TEST(Growth, IsNotToldOfNoise) {
  test::Noise noise(1e-3);
  const RunHistory run =
      synthetic_run(unequal_times(16, 0.02), 1, 1, [&](double, double) { return noise(); });
  EXPECT_FALSE(growth_of(run).growth);
}

TEST(Growth, IsNotToldOfAFlagAtRest) {
  const RunHistory run =
      synthetic_run(unequal_times(16, 0.02), 1, 1, [](double, double) { return 0.0; });
  EXPECT_FALSE(growth_of(run).growth);
}

TEST(Series, SplineIsOfFourthOrderOnUnequalRows) {
  const auto error = [](double dt) {
    const std::vector<double> t = unequal_times(6, dt);
    std::vector<double> values;
    values.reserve(t.size());
    for (const double time : t) values.push_back(std::sin(2 * time));
    double largest = 0;
    for (const double time : equal_times(2, 4, 500))
      largest = std::max(largest, std::abs(Spline(t, values)(time) - std::sin(2 * time)));
    return largest;
  };
  EXPECT_GT(error(0.1) / error(0.05), 12);
}

}  // namespace
}  // namespace pennon::analysis

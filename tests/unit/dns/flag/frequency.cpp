/// The frequency of a vibration from its samples.
#include "dns/flag/frequency.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace pennon::dns {
namespace {

std::vector<double> samples(double omega, double decay, double phase, double dt, double t_end) {
  std::vector<double> z;
  for (int n = 0; n * dt <= t_end; ++n)
    z.push_back(1e-6 * std::exp(-decay * n * dt) * std::cos(omega * n * dt + phase));
  return z;
}

TEST(FrequencyOfAVibration, IsExactWhateverItsPhaseDecayAndStep) {
  constexpr double omega = 19.7;
  constexpr double rounding = 1e-12;  // of sums of a thousand products
  for (const double phase : {0.0, 0.4, 2.0, -1.5})
    for (const double decay : {0.0, 0.5, -0.1})
      for (const double dt : {0.1, 0.01, 0.001}) {
        const auto found = angular_frequency(samples(omega, decay, phase, dt, 1), dt);
        ASSERT_TRUE(found) << phase << ' ' << decay << ' ' << dt;
        EXPECT_NEAR(*found / omega, 1, rounding) << phase << ' ' << decay << ' ' << dt;
      }
}

TEST(FrequencyOfAVibration, SuffersLittleFromTheNoiseOfItsSamples) {
  constexpr double omega = 2;
  constexpr double dt = 1e-3;
  std::vector<double> z = samples(omega, 0, 0, dt, 10);
  double sign = 1;
  for (double& value : z) value += 1e-12 * (sign = -sign);  // a millionth of the amplitude
  EXPECT_NEAR(*angular_frequency(z, dt) / omega, 1, 1e-7);
}

TEST(FrequencyOfAVibration, IsNotMadeUp) {
  EXPECT_FALSE(angular_frequency({}, 0.1));
  EXPECT_FALSE(angular_frequency(std::vector<double>(100, 0.0), 0.1));
  EXPECT_FALSE(angular_frequency(samples(1, 0, 0, 0.01, 1.5), 0.01)) << "ends before zero";
  EXPECT_FALSE(angular_frequency(samples(1, 0, 0, 0.01, 4), 0.01)) << "ends after one zero";
}

}  // namespace
}  // namespace pennon::dns

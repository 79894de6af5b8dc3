/// The values along a sweep.
#include "common/case/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "common/case/range.hpp"

namespace pennon {
namespace {

TEST(Sweep, EndsExactlyAtItsEndsAndNeverTurnsBack) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> exponent(-30, 30);
  for (int round = 0; round < 5000; ++round) {
    Sweep sweep;
    sweep.scale = round % 2 == 0 ? Scale::log : Scale::linear;
    sweep.from = std::pow(10, exponent(random));
    // Every fourth is so narrow that neighbours differ by a few roundoffs only.
    sweep.to =
        round % 4 == 0 ? sweep.from * (1 + 1e-15) : sweep.from + std::pow(10, exponent(random));
    if (sweep.from >= sweep.to) continue;
    sweep.points = 2 + static_cast<std::int64_t>(random() % 200);
    const std::vector<double> values = sweep.values();
    ASSERT_EQ(values.size(), static_cast<std::size_t>(sweep.points));
    ASSERT_EQ(values.front(), sweep.from);
    ASSERT_EQ(values.back(), sweep.to);
    ASSERT_TRUE(std::ranges::is_sorted(values)) << sweep.from << " to " << sweep.to;
  }
}

TEST(Sweep, IsEquallySpacedOnItsScale) {
  const Sweep linear{-1, 3, 5, Scale::linear, {}};
  EXPECT_EQ(linear.values(), (std::vector<double>{-1, 0, 1, 2, 3}));
  const Sweep log{1e-2, 1e2, 5, Scale::log, {}};
  for (std::int64_t i = 0; i < 5; ++i)
    EXPECT_NEAR(log.at(i) / std::pow(10, static_cast<double>(i) - 2), 1, 1e-15 * 10);
}

TEST(Sweep, SpansAllThatARangeAllows) {
  const Sweep log{positive.low, positive.high, 61, Scale::log, {}};
  for (std::int64_t i = 0; i < log.size(); ++i)
    EXPECT_NEAR(std::log10(log.at(i)), static_cast<double>(i) - 30, 1e-12);
  const Sweep linear{any_sign.low, any_sign.high, 3, Scale::linear, {}};
  EXPECT_EQ(linear.at(1), 0);
}

// Doubles lie closer at 0 than at 1, so that 2^60 points differ at the one end and not at the
// other.
TEST(Sweep, DoesNotIncreaseWhereItsPointsAreCloserThanDoublesAtEitherEnd) {
  constexpr std::int64_t many = std::int64_t{1} << 60;
  EXPECT_FALSE((Sweep{0, 1, many, Scale::linear, {}}.is_increasing()));
  EXPECT_FALSE((Sweep{-1, 0, many, Scale::linear, {}}.is_increasing()));
  EXPECT_TRUE((Sweep{0, 1, 1 << 20, Scale::linear, {}}.is_increasing()));
}

TEST(Sweep, IsItsListWhereItHasOne) {
  const Sweep sweep{0, 0, 0, Scale::linear, {3, 1, 2}};
  EXPECT_EQ(sweep.size(), 3);
  EXPECT_EQ(sweep.values(), (std::vector<double>{3, 1, 2}));
}

}  // namespace
}  // namespace pennon

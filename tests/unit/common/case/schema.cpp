/// What is written from the declarations of a case: its resolved text and its reference.
#include "common/case/schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "tests/support/every_type_case.hpp"

namespace pennon::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

// A double with random bits whose magnitude a case accepts.
double random_double(std::mt19937_64& random) {
  for (;;) {
    const double value = std::bit_cast<double>(random());
    if (any_sign.contains(value)) return value;
  }
}

std::uint64_t bits(double value) {
  return std::bit_cast<std::uint64_t>(value);
}

TEST(ResolvedText, ReadsBackToTheSameBits) {
  std::mt19937_64 random(20240607);
  for (int round = 0; round < 2000; ++round) {
    EveryTypeCase written;
    written.has_types = written.has_inner = true;
    written.flag.mu = std::abs(random_double(random)) + positive.low;
    written.maybe_number = random_double(random);
    for (double& value : written.triple) value = random_double(random);
    written.integer = static_cast<std::int64_t>(random() % 100 + 1);
    Sweep sweep;
    sweep.from = 1 + 1.0 / static_cast<double>(random());
    sweep.to = sweep.from * (2 + 1e-3 * static_cast<double>(random() % 1000));
    sweep.points = 2 + static_cast<std::int64_t>(random() % 1000000000);
    sweep.scale = round % 2 == 0 ? Scale::log : Scale::linear;
    if (round % 3 == 0) sweep.list = {sweep.from, sweep.to};
    written.sweep = sweep;

    EveryTypeCase found;
    const std::string text = resolved_text(written.schema());
    ASSERT_NO_THROW(found.read(text)) << text;
    ASSERT_EQ(resolved_text(found.schema()), text);
    ASSERT_EQ(bits(found.flag.mu), bits(written.flag.mu)) << text;
    ASSERT_EQ(bits(*found.maybe_number), bits(*written.maybe_number)) << text;
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_EQ(bits(found.triple[i]), bits(written.triple[i])) << text;
    ASSERT_EQ(found.integer, written.integer);
    ASSERT_EQ(found.sweep->list, sweep.list);
    if (!sweep.list.empty()) continue;
    ASSERT_EQ(bits(found.sweep->from), bits(sweep.from)) << text;
    ASSERT_EQ(bits(found.sweep->to), bits(sweep.to)) << text;
    ASSERT_EQ(found.sweep->points, sweep.points);
    ASSERT_EQ(found.sweep->scale, sweep.scale);
  }
}

TEST(ResolvedText, ReadsBackAtTheEndsOfTheDoubles) {
  for (const double value :
       {0.0, -0.0, 1e16, 1e22, 1e30, -1e30, 123456789012345678.0, 0.1,
        std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::min()}) {
    EveryTypeCase written;
    written.flag.mu = 1;
    written.has_types = true;
    written.maybe_number = value;
    EveryTypeCase found;
    const std::string text = resolved_text(written.schema());
    ASSERT_NO_THROW(found.read(text)) << text;
    EXPECT_EQ(bits(*found.maybe_number), bits(value)) << text;
  }
}

TEST(ResolvedText, ReadsBackAnyText) {
  EveryTypeCase written;
  written.flag.mu = 1;
  written.has_types = true;
  written.texts = {"", "\"quotes\" and \\ ", "two\nlines\r\n\tand a tab", "\x01\x7f", "µ ω 旗 🚩"};
  written.text = written.texts[1];
  EveryTypeCase found;
  found.read(resolved_text(written.schema()));
  EXPECT_EQ(found.texts, written.texts);
  EXPECT_EQ(found.text, written.text);
}

TEST(ResolvedText, LeavesOutTablesTheCaseDidNotHaveAndKeysWithoutValue) {
  EveryTypeCase found;
  found.read("[flag]\nmu = 1\n[types]\n");
  const std::string text = resolved_text(found.schema());
  EXPECT_THAT(text, Not(HasSubstr("[flow]")));
  EXPECT_THAT(text, Not(HasSubstr("maybe_number")));
  EXPECT_THAT(text, HasSubstr("[types]"));
  EXPECT_THAT(text, HasSubstr("leading_edge = \"pinned\""));
}

TEST(ReferenceText, HasALineForEachKey) {
  EveryTypeCase defaults;
  const Schema schema = defaults.schema();
  const std::string text = reference_text(schema);
  for (const Table& table : schema.tables) {
    EXPECT_THAT(text, HasSubstr("## [" + table.name + "]"));
    for (const Key& key : table.keys) EXPECT_THAT(text, HasSubstr("| `" + key.name + "` | "));
  }
  EXPECT_THAT(text, HasSubstr("| `mu` | number | mass ratio rho_s h/(rho_f L) | "));
  EXPECT_THAT(text, HasSubstr("| `shade` | choice | a choice | dark, light | \"dark\" |"));
  EXPECT_THAT(text, HasSubstr("| `known_text` | text | one of two | wu, lamb | \"wu\" |"));
}

}  // namespace
}  // namespace pennon::test

/// A hundred thousand damaged HDF5 files (tests/support/foreign_files.hpp), in four tests that can
/// run side by side.
#include "tests/support/foreign_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace pennon::test {
namespace {

class ForeignFilesValidation : public testing::TestWithParam<int> {};

TEST_P(ForeignFilesValidation, AreAnsweredInWords) {
  ForeignFiles files;
  constexpr std::int64_t count = 1000, rounds = 25;
  constexpr long most_kilobytes = 200'000;
  const std::int64_t before = rounds * GetParam();
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> of_kind;  // refused, taken
  for (std::int64_t round = 0; round < rounds; ++round) {
    const Answers answers =
        files.damage(count, 1'000'000 + static_cast<std::uint64_t>((before + round) * count));
    EXPECT_THAT(answers.faults, testing::IsEmpty()) << "round " << round;
    EXPECT_LT(answers.memory_kilobytes, most_kilobytes) << "round " << round;
    for (const auto& [kind, number] : answers.refused) of_kind[kind].first += number;
    for (const auto& [kind, number] : answers.taken) of_kind[kind].second += number;
    fmt::print(stderr, "{} of {} files\n", (round + 1) * count, rounds * count);
  }
  for (const auto& [kind, numbers] : of_kind)
    fmt::print("{}: {} refused, {} taken\n", kind, numbers.first, numbers.second);
}

INSTANTIATE_TEST_SUITE_P(InQuarters, ForeignFilesValidation, testing::Range(0, 4));

}  // namespace
}  // namespace pennon::test

/// A hundred thousand damaged HDF5 files (tests/support/foreign_files.hpp).
#include "tests/support/foreign_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>

namespace pennon::test {
namespace {

TEST(ForeignFilesValidation, AreAnsweredInWords) {
  ForeignFiles files;
  constexpr std::int64_t count = 1000, rounds = 100;
  constexpr long most_kilobytes = 200'000;
  std::map<std::string, std::pair<std::int64_t, std::int64_t>> of_kind;  // refused, taken
  for (std::int64_t round = 0; round < rounds; ++round) {
    const Answers answers =
        files.damage(count, 1'000'000 + static_cast<std::uint64_t>(round * count));
    EXPECT_THAT(answers.faults, testing::IsEmpty()) << "round " << round;
    EXPECT_LT(answers.memory_kilobytes, most_kilobytes) << "round " << round;
    for (const auto& [kind, number] : answers.refused) of_kind[kind].first += number;
    for (const auto& [kind, number] : answers.taken) of_kind[kind].second += number;
    fmt::print(stderr, "{} of {} files\n", (round + 1) * count, rounds * count);
  }
  for (const auto& [kind, numbers] : of_kind)
    fmt::print("{}: {} refused, {} taken\n", kind, numbers.first, numbers.second);
}

}  // namespace
}  // namespace pennon::test

/// Damaged HDF5 files are answered in words (tests/support/foreign_files.hpp).
#include "tests/support/foreign_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pennon::test {
namespace {

TEST(ForeignFiles, AreAnsweredInWords) {
  ForeignFiles files;
  constexpr std::int64_t count = 1000;
  constexpr long most_kilobytes = 200'000;
  const Answers answers = files.damage(count, 1);
  EXPECT_THAT(answers.faults, testing::IsEmpty());
  EXPECT_LT(answers.memory_kilobytes, most_kilobytes);
  // The damage is felt: of each kind some files are refused, and some are not.
  EXPECT_EQ(answers.refused.size(), files.kinds());
  for (const auto& [kind, refused] : answers.refused) {
    EXPECT_GT(refused, 5) << kind;
    const auto taken = answers.taken.find(kind);
    fmt::print("{}: {} refused, {} taken\n", kind, refused,
               taken == answers.taken.end() ? 0 : taken->second);
  }
  EXPECT_GT(answers.taken.size(), 10U);
}

}  // namespace
}  // namespace pennon::test

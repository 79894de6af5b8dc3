/// A hundred thousand damaged HDF5 files (tests/support/foreign_files.hpp).
#include "tests/support/foreign_files.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace pennon::test {
namespace {

TEST(ForeignFilesValidation, AreAnsweredInWords) {
  ForeignFiles files;
  constexpr std::int64_t count = 100'000;
  constexpr long most_kilobytes = 200'000;
  const Answers answers = files.damage(count, 1'000'000);
  EXPECT_THAT(answers.faults, testing::IsEmpty());
  EXPECT_LT(answers.memory_kilobytes, most_kilobytes);
  for (const auto& [kind, refused] : answers.refused)
    fmt::print("{}: {} refused, {} taken\n", kind, refused,
               answers.taken.contains(kind) ? answers.taken.at(kind) : 0);
}

}  // namespace
}  // namespace pennon::test

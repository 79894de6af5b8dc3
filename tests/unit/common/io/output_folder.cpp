/// The folder a run writes to, found unusable before the run and not after it.
#include "common/io/output_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <limits>

#include "common/errors.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string failure_of(const std::filesystem::path& folder) {
  try {
    const OutputFolder made(folder);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

TEST(OutputFolder, IsMadeWithThoseAboveItAndLeftEmpty) {
  const TemporaryFolder folder;
  const OutputFolder output(folder / "a/b/c");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b/c"));
  EXPECT_TRUE(std::filesystem::is_empty(folder / "a/b/c"));
  EXPECT_EQ(output / "x.csv", folder / "a/b/c/x.csv");
  EXPECT_EQ(failure_of(folder / "a/b/c"), "");
}

TEST(OutputFolder, IsRefusedUnderAFile) {
  const TemporaryFolder folder;
  const auto file = write_text(folder / "file", "x");
  const auto is_said = AllOf(HasSubstr(file.string()), HasSubstr("cannot be made"),
                             HasSubstr("Not a directory"), HasSubstr("--output"));
  EXPECT_THAT(failure_of(file / "inside"), is_said);
  EXPECT_THAT(failure_of(file), is_said);
  EXPECT_THAT(failure_of(""), HasSubstr("cannot be made"));
}

TEST(OutputFolder, IsRefusedWhereItMayNotBeWritten) {
  const TemporaryFolder folder;
  ASSERT_EQ(chmod(folder.path().c_str(), 0555), 0);
  const ChildEnd end = in_child([&] {
    constexpr uid_t nobody = 65534;
    if (getuid() == 0 && setuid(nobody) != 0) return 1;
    const std::string words = "Permission denied";
    if (failure_of(folder.path()).find(words) == std::string::npos) return 2;
    return failure_of(folder / "new").find(words) == std::string::npos ? 3 : 0;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(OutputFolder, IsRefusedOnAFullDisk) {
  const TemporaryFolder folder;
  const ChildEnd end = in_child([&] {
    have_small_disk(folder.path(), 64 << 10);
    const std::string what = failure_of(folder.path());
    const bool is_said = what.find("No space left") != std::string::npos ||
                         what.find("File too large") != std::string::npos;
    return is_said && folder.names().empty() ? 0 : 1;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(OutputFolder, SaysHowMuchSpaceALargeResultNeeds) {
  const TemporaryFolder folder;
  const OutputFolder output(folder.path());
  EXPECT_NO_THROW(output.require_space(1, "a byte"));
  try {
    output.require_space(std::numeric_limits<std::uintmax_t>::max(), "the map");
    FAIL();
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the map needs 1.84e+10 GB in the output folder"));
  }
  EXPECT_THAT(folder.names(), IsEmpty());
}

}  // namespace
}  // namespace pennon::test

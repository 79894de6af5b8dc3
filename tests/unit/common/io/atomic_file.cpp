/// Files that are written whole or not at all.
#include "common/io/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <string>

#include "common/errors.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/small_disk.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(AtomicFile, HasItsFinalNameOnlyWhenFinished) {
  const TemporaryFolder folder;
  AtomicFile file(folder / "result.csv");
  EXPECT_EQ(file.temporary().extension(), ".csv");
  EXPECT_EQ(file.temporary().parent_path(), folder.path());
  write_text(file.temporary(), "whole");
  EXPECT_FALSE(std::filesystem::exists(folder / "result.csv"));
  file.finish();
  EXPECT_THAT(folder.names(), ElementsAre("result.csv"));
  EXPECT_EQ(read_text(folder / "result.csv"), "whole");
}

TEST(AtomicFile, LeavesNothingWhereItsWriterGivesUp) {
  const TemporaryFolder folder;
  { const AtomicFile never_written(folder / "a"); }
  {
    const AtomicFile unfinished(folder / "b");
    write_text(unfinished.temporary(), "half");
  }
  EXPECT_THAT(folder.names(), IsEmpty());
}

TEST(AtomicFile, KeepsTheLastWholeFileWhereItsWriterIsKilled) {
  const TemporaryFolder folder;
  write_file(folder / "result", "the last one");
  const ChildEnd end = in_child([&] {
    const AtomicFile file(folder / "result");
    write_text(file.temporary(), std::string(1 << 20, 'x'));
    return raise(SIGKILL);
  });
  EXPECT_EQ(end.signal, SIGKILL);
  EXPECT_EQ(read_text(folder / "result"), "the last one");
}

TEST(AtomicFile, SaysWhatTheSystemSaid) {
  const TemporaryFolder folder;
  EXPECT_THAT(failure_of<FileError>([&] { write_file(folder / "absent" / "f", "x"); }),
              AllOf(HasSubstr("cannot be written"), HasSubstr("No such file or directory")));
  write_file(folder / "file", "x");
  EXPECT_THAT(failure_of<FileError>([&] { write_file(folder / "file" / "f", "x"); }),
              HasSubstr("Not a directory"));
  std::filesystem::create_directory(folder / "taken");
  EXPECT_THAT(failure_of<FileError>([&] { write_file(folder / "taken", "x"); }),
              AllOf(HasSubstr("taken cannot be written"), HasSubstr("Is a directory")));
  EXPECT_THAT(folder.names(), ElementsAre("file", "taken"));
}

TEST(AtomicFile, LeavesTheLastWholeFileOnAFullDisk) {
  const TemporaryFolder folder;
  const ChildEnd end = in_child([&] {
    have_small_disk(folder.path(), 64 << 10);
    write_file(folder / "result", "the last one");
    const std::string what =
        failure_of<FileError>([&] { write_file(folder / "result", std::string(1 << 20, 'x')); });
    if (what.find("No space left") == std::string::npos &&
        what.find("File too large") == std::string::npos)
      return 1;
    return folder.names().size() == 1 && read_text(folder / "result") == "the last one" ? 0 : 2;
  });
  EXPECT_EQ(end.status, 0);
}

}  // namespace
}  // namespace pennon::test

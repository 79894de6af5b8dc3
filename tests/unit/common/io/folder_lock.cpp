/// One process at a time writes into a folder, and what a killed one leaves is recognised.
#include "common/io/folder_lock.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

TEST(FolderLock, IsHeldByOneAndGivenBack) {
  const TemporaryFolder folder;
  {
    const FolderLock first(folder.path(), false);
    EXPECT_THAT(folder.names(), ElementsAre(".lock"));
    EXPECT_THAT(failure_of<InputError>([&] { FolderLock(folder.path(), true); }),
                AllOf(HasSubstr(folder.path().string() + ": is being written to by process " +
                                std::to_string(getpid())),
                      HasSubstr("--output")));
  }
  EXPECT_THAT(folder.names(), IsEmpty());
  const FolderLock second(folder.path(), false);
}

TEST(FolderLock, OfAKilledProcessIsTakenOver) {
  const TemporaryFolder folder;
  const ChildEnd end = in_child([&] {
    const FolderLock lock(folder.path(), false);
    return raise(SIGKILL);
  });
  ASSERT_EQ(end.signal, SIGKILL);
  EXPECT_THAT(folder.names(), ElementsAre(".lock"));
  const FolderLock next(folder.path(), false);
}

TEST(FolderLock, OfAnotherMachineIsTakenOverWhereThatIsForced) {
  const TemporaryFolder folder;
  write_text(folder / ".lock", "4711 elsewhere\n");
  EXPECT_THAT(failure_of<InputError>([&] { FolderLock(folder.path(), false); }),
              AllOf(HasSubstr("process 4711 on elsewhere"), HasSubstr("--force")));
  const FolderLock forced(folder.path(), true);
  EXPECT_THAT(read_text(folder / ".lock"), HasSubstr(std::to_string(getpid())));
}

// Where someone laid a link under the lock's name, what it leads to stays as it is.
TEST(FolderLock, FollowsNoLink) {
  const TemporaryFolder folder;
  write_text(folder / "precious", "text");
  std::filesystem::create_symlink(folder / "precious", folder / ".lock");
  EXPECT_THAT(failure_of<FileError>([&] { FolderLock(folder.path(), true); }),
              HasSubstr("cannot be locked"));
  EXPECT_EQ(read_text(folder / "precious"), "text");
}

TEST(StaleTemporaries, AreThoseOfProcessesThatAreGone) {
  const TemporaryFolder folder;
  std::filesystem::path of_killed;
  const ChildEnd end = in_child([&] {
    write_text(temporary_name(folder / "fields_00001.h5"), "half");
    return raise(SIGKILL);
  });
  ASSERT_EQ(end.signal, SIGKILL);
  ASSERT_EQ(folder.names().size(), 1U);
  const AtomicFile living(folder / "living.csv");
  write_text(living.temporary(), "half");
  // Names that are not quite those of temporary files.
  const std::vector<std::string> others = {".notes.tmp", "a.999999-0123456789abcdef.tmp",
                                           ".a.999999-0123.tmp", ".a.x-0123456789abcdef.tmp"};
  for (const std::string& name : others) write_text(folder / name, "mine");
  remove_stale_temporaries(folder.path());
  EXPECT_EQ(folder.names().size(), others.size() + 1);
  EXPECT_TRUE(std::filesystem::exists(living.temporary()));
}

}  // namespace
}  // namespace pennon::test

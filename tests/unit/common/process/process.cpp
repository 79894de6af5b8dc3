/// Child programs: what they are given, what comes back, and how they end.
#include "common/process/process.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon {
namespace {

using test::failure_of;
using test::in_child;
using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;

ChildProgram shell(const std::string& script) {
  return {.program = "/bin/sh", .arguments = {"-c", script}};
}

// Seconds that `work` takes.
template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

TEST(Process, ReadsItsInputAndWritesItsOutputWhole) {
  const TemporaryFolder folder;
  std::string text;  // more than a pipe holds, with zeros
  for (int k = 0; k < 1'000'000; ++k) text += static_cast<char>(k % 251);
  const ChildEnd end =
      run_program({.program = "/bin/cat", .input = text, .output = folder / "copy"});
  EXPECT_TRUE(end.is_success());
  EXPECT_EQ(end.messages, "");
  EXPECT_EQ(test::read_text(folder / "copy"), text);
}

TEST(Process, ReadsItsDataAsOftenAsItLikes) {
  const TemporaryFolder folder;
  const std::string twice = fmt::format("cat {0}; cat - {0}", data_file);
  ChildProgram program = shell(twice);
  program.input = "input";
  program.data = "data";
  program.output = folder / "read";
  EXPECT_TRUE(run_program(program).is_success());
  EXPECT_EQ(test::read_text(folder / "read"), "datainputdata");
}

TEST(Process, DoesNotGetTheVariablesThatAreUnset) {
  const TemporaryFolder folder;
  const test::ChildEnd end = in_child([&] {
    setenv("PENNON_TEST_A", "a", 1);
    setenv("PENNON_TEST_AB", "ab", 1);
    ChildProgram program = shell("echo ${PENNON_TEST_A-none} $PENNON_TEST_AB");
    program.output = folder / "variables";
    program.unset = {"PENNON_TEST_A"};
    return run_program(program).exit_status;
  });
  EXPECT_EQ(end.status, 0);
  EXPECT_EQ(test::read_text(folder / "variables"), "none ab\n");
}

TEST(Process, MayEndBeforeItHasReadItsInput) {
  const std::string text(1'000'000, 'x');
  ChildProgram program = shell("exit 0");
  program.input = text;
  EXPECT_TRUE(run_program(program).is_success());
}

TEST(Process, IsGivenItsArgumentsWithoutAShell) {
  const TemporaryFolder folder;
  run_program(
      {.program = "/bin/echo", .arguments = {"$HOME", "a b", "'"}, .output = folder / "words"});
  EXPECT_EQ(test::read_text(folder / "words"), "$HOME a b '\n");
}

TEST(Process, SaysHowItEndedAndWhatItSaid) {
  const ChildEnd failed = run_program(shell("echo what; echo is wrong >&2; exit 3"));
  EXPECT_EQ(failed.exit_status, 3);
  EXPECT_EQ(failed.signal, 0);
  EXPECT_EQ(failed.messages, "is wrong\n");
  EXPECT_FALSE(failed.is_success());
  const ChildEnd killed = run_program(shell("kill -KILL $$"));
  EXPECT_EQ(killed.signal, SIGKILL);
  EXPECT_EQ(killed.exit_status, 0);
  EXPECT_FALSE(killed.is_success());
}

TEST(Process, HandsOverItsLinesAsTheyCome) {
  std::vector<std::string> lines;
  ChildProgram program = shell(
      "printf 'progress: 1' >&2; sleep 0.1; printf ' of 2\\nwhat\\nprogress: 2 of 2\\nend' >&2");
  program.takes_line = [&](std::string_view line) {
    lines.emplace_back(line);
    return line.starts_with("progress");
  };
  EXPECT_EQ(run_program(program).messages, "what\nend");
  EXPECT_THAT(lines, testing::ElementsAre("progress: 1 of 2", "what", "progress: 2 of 2"));
}

TEST(Process, IsFoundInTheFoldersOfThePath) {
  const TemporaryFolder folder;
  test::write_text(folder / "tool", "#!/bin/sh\n");
  const test::ChildEnd end = in_child([&] {
    setenv("PATH", ("/nowhere:" + folder.path().string()).c_str(), 1);
    if (find_program("tool")) return 1;  // it may not be executed yet
    std::filesystem::permissions(folder / "tool", std::filesystem::perms::owner_all);
    if (find_program("tool") != folder / "tool") return 2;
    if (find_program((folder / "tool").string()) != folder / "tool") return 3;
    return find_program("sh") ? 4 : 0;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(Process, ThatCannotBeStartedIsNamed) {
  const TemporaryFolder folder;
  EXPECT_THAT(failure_of<FileError>([&] { run_program({.program = folder / "nothing"}); }),
              AllOf(HasSubstr("nothing cannot be started"), HasSubstr("No such file")));
  EXPECT_THAT(failure_of<FileError>([&] {
                run_program({.program = "/bin/cat", .output = folder / "no" / "folder"});
              }),
              AllOf(HasSubstr("no/folder cannot be written"), HasSubstr("No such file")));
}

TEST(Process, IsToldOfAnInterruptOnlyWhereItAsks) {
  for (const bool is_interruptible : {true, false}) {
    const test::ChildEnd end = in_child([&] {
      watch_for_interrupts();
      std::raise(SIGTERM);
      const ChildProgram program{.program = "/bin/sleep",
                                 .arguments = {is_interruptible ? "20" : "0.5"},
                                 .is_interruptible = is_interruptible};
      ChildEnd child;
      const double seconds = seconds_of([&] { child = run_program(program); });
      if (is_interruptible) return child.signal == SIGTERM && seconds < 10 ? 0 : 1;
      return child.is_success() ? 0 : 2;
    });
    EXPECT_EQ(end.status, 0) << is_interruptible;
  }
}

TEST(Process, IsKilledWhereItDoesNotEndAtAnInterrupt) {
  const test::ChildEnd end = in_child([&] {
    watch_for_interrupts();
    std::thread later([] {  // when the shell has set its trap
      std::this_thread::sleep_for(std::chrono::milliseconds(500));
      kill(getpid(), SIGTERM);
    });
    later.detach();
    ChildProgram program = shell("trap '' TERM; while :; do sleep 0.1; done");
    program.is_interruptible = true;
    ChildEnd child;
    const double seconds = seconds_of([&] { child = run_program(program); });
    return child.signal == SIGKILL && seconds < 10 ? 0 : 1;
  });
  EXPECT_EQ(end.status, 0);
}

TEST(Process, EndsWithItsParent) {
  const TemporaryFolder folder;
  const std::filesystem::path sign = folder / "sign";
  const pid_t parent = fork();
  if (parent == 0) {
    run_program(shell("trap 'echo ended > " + sign.string() + "; exit' TERM; echo > " +
                      sign.string() + "; while :; do sleep 0.05; done"));
    _exit(0);
  }
  const auto wait_for = [&](const std::string& text) {
    for (int k = 0; k < 1000 && test::read_text(sign) != text; ++k)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    return test::read_text(sign) == text;
  };
  EXPECT_TRUE(wait_for("\n"));
  kill(parent, SIGKILL);
  waitpid(parent, nullptr, 0);
  EXPECT_TRUE(wait_for("ended\n"));
}

}  // namespace
}  // namespace pennon

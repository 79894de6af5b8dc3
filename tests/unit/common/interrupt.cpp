/// The signals that ask pennon to stop.
#include "common/interrupt.hpp"

#include <gtest/gtest.h>
#include <signal.h>

#include <csignal>
#include <string>

#include "common/errors.hpp"
#include "tests/support/child_process.hpp"
#include "tests/support/failure.hpp"

namespace pennon {
namespace {

using test::failure_of;
using test::in_child;

// What the child says of a signal, as its exit status: 0 if it is what was expected.
int status_of(int signal, const std::string& sentence) {
  watch_for_interrupts();
  stop_if_interrupted("go on");
  if (is_interrupted()) return 1;
  std::raise(signal);
  if (!is_interrupted()) return 2;
  return failure_of<Interrupted>([] { stop_if_interrupted("go on"); }) == sentence ? 0 : 3;
}

TEST(Interrupts, AreNotedWithTheNameOfTheirSignal) {
  for (const auto& [signal, name] :
       {std::pair(SIGINT, "Ctrl-C"), std::pair(SIGTERM, "SIGTERM"), std::pair(SIGUSR1, "SIGUSR1"),
        std::pair(SIGUSR2, "SIGUSR2"), std::pair(SIGHUP, "the end of its terminal (SIGHUP)")}) {
    const std::string sentence = std::string("stopped by ") + name + "; go on";
    const int number = signal;
    EXPECT_EQ(in_child([&] { return status_of(number, sentence); }).status, 0) << name;
  }
}

TEST(Interrupts, EndTheProcessAtASecondCtrlCOnly) {
  const auto end_after = [](int first, int second) {
    return in_child([=] {
      watch_for_interrupts();
      std::raise(first);
      std::raise(second);
      return 0;
    });
  };
  EXPECT_EQ(end_after(SIGINT, SIGINT).signal, SIGINT);
  EXPECT_EQ(end_after(SIGINT, SIGTERM).status, 0);
  EXPECT_EQ(end_after(SIGTERM, SIGTERM).status, 0);
  EXPECT_EQ(end_after(SIGUSR1, SIGTERM).status, 0);
}

TEST(Interrupts, LeaveAnIgnoredEndOfTheTerminalIgnored) {
  const test::ChildEnd end = in_child([] {
    std::signal(SIGHUP, SIG_IGN);
    watch_for_interrupts();
    std::raise(SIGHUP);
    return is_interrupted() ? 1 : 0;
  });
  EXPECT_EQ(end.status, 0);
}

}  // namespace
}  // namespace pennon

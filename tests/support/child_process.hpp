/// Work done in a process of its own, for what must not happen to the test's: to be killed, to lose
/// its rights, to meet a full disk.
#pragma once

#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <stdexcept>

namespace pennon::test {

/// How a child ended: its exit status, or the signal that killed it.
struct ChildEnd {
  int status = -1;
  int signal = 0;
};

/// Runs `work` in a child, whose exit status is what it returns; 99 if it throws.
inline ChildEnd in_child(const std::function<int()>& work) {
  const pid_t child = fork();
  if (child < 0) throw std::runtime_error("no child process");
  if (child == 0) {
    int status = 99;
    try {
      status = work();
    } catch (...) {
      // told by the status
    }
    _exit(status);
  }
  int status = 0;
  waitpid(child, &status, 0);
  if (WIFSIGNALED(status)) return {-1, WTERMSIG(status)};
  return {WEXITSTATUS(status), 0};
}

}  // namespace pennon::test

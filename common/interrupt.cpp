#include "common/interrupt.hpp"

#include <signal.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <string>

#include "common/errors.hpp"

namespace pennon {
namespace {

struct Watched {
  int number;
  const char* name;
};
constexpr std::array<Watched, 5> watched = {{{SIGINT, "Ctrl-C"},
                                             {SIGTERM, "SIGTERM"},
                                             {SIGUSR1, "SIGUSR1"},
                                             {SIGUSR2, "SIGUSR2"},
                                             {SIGHUP, "the end of its terminal (SIGHUP)"}}};

volatile std::sig_atomic_t caught_signal = 0;
std::atomic<std::int64_t> caught_at = 0;  // the monotonic clock, in nanoseconds; 0: not yet
static_assert(std::atomic<std::int64_t>::is_always_lock_free, "a signal may set it");

std::int64_t now() {
  constexpr std::int64_t nanoseconds = 1'000'000'000;
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * nanoseconds + time.tv_nsec;
}

void note(int signal) {
  if (signal == SIGINT && caught_signal == SIGINT) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  caught_signal = signal;
  if (caught_at == 0) caught_at = now();
}

}  // namespace

void watch_for_interrupts() {
  for (const Watched& signal : watched) {
    struct sigaction action {};
    if (signal.number == SIGHUP && sigaction(SIGHUP, nullptr, &action) == 0 &&
        action.sa_handler == SIG_IGN)
      continue;
    action = {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;  // system calls go on, as with std::signal
    sigaction(signal.number, &action, nullptr);
  }
}

bool is_interrupted() {
  return caught_signal != 0;
}

bool was_interrupted_before(double seconds) {
  constexpr double nanosecond = 1e-9;
  const std::int64_t since = caught_at;
  return since != 0 && nanosecond * static_cast<double>(now() - since) > seconds;
}

void stop_if_interrupted(const char* advice) {
  if (!is_interrupted()) return;
  const int caught = caught_signal;
  const auto* const signal = std::ranges::find(watched, caught, &Watched::number);
  throw Interrupted(std::string("stopped by ") + signal->name + "; " + advice);
}

}  // namespace pennon

#include "common/interrupt.hpp"

#include <csignal>
#include <string>

#include "common/errors.hpp"

namespace pennon {
namespace {

volatile std::sig_atomic_t caught_signal = 0;

void note(int signal) {
  if (caught_signal != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  caught_signal = signal;
}

}  // namespace

void watch_for_interrupts() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

bool is_interrupted() {
  return caught_signal != 0;
}

void stop_if_interrupted(const char* advice) {
  if (!is_interrupted()) return;
  const std::string name = caught_signal == SIGINT ? "Ctrl-C" : "SIGTERM";
  throw Interrupted("stopped by " + name + "; " + advice);
}

}  // namespace pennon

/// Wall time in seconds.
#pragma once

#include <chrono>
#include <utility>

namespace pennon {

class StopWatch {
 public:
  /// Since the construction or the last lap.
  double seconds() const { return Seconds(Clock::now() - last_).count(); }
  /// The same, and a new lap begins.
  double lap() {
    const Clock::time_point now = Clock::now();
    return Seconds(now - std::exchange(last_, now)).count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  using Seconds = std::chrono::duration<double>;
  Clock::time_point last_ = Clock::now();
};

}  // namespace pennon

/// How far long work has come: a bar with the time left on a terminal, plain lines in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

namespace pennon {

class Progress {
 public:
  /// Shows nothing before `quiet_for` has passed, so that short work stays silent.
  Progress(std::string what, std::int64_t total, bool is_shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void advance_to(std::int64_t done);

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::int64_t done, Clock::time_point now);

  std::string what_;
  std::int64_t total_;
  bool is_shown_;
  bool is_terminal_;
  bool has_drawn_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_shown_ = begin_;
};

}  // namespace pennon

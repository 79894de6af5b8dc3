/// How far long work has come: a bar with the time left on a terminal, plain lines in a log.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>

namespace pennon {

class Progress {
 public:
  /// Shows nothing before `quiet_for` has passed, so that short work stays silent.
  Progress(std::string what, std::int64_t total, bool is_shown);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `detail`, where there is one, gives what to say beside the time left; it is called when there
  /// is something to show.
  void advance_to(std::int64_t done, const std::function<std::string()>& detail = {});
  /// Work that goes on where `done` was reached before: the time left is told from what is done
  /// now.
  void begin_at(std::int64_t done) { begun_at_ = done; }

 private:
  using Clock = std::chrono::steady_clock;
  void show(std::int64_t done, Clock::time_point now, const std::string& detail);

  std::string what_;
  std::int64_t total_, begun_at_ = 0;
  bool is_shown_;
  bool is_terminal_;
  bool has_drawn_ = false;
  Clock::time_point begin_ = Clock::now();
  Clock::time_point last_shown_ = begin_;
};

}  // namespace pennon

/// What made a result: version, commit, libraries, ranks, wall time by phase, peak memory. Written
/// beside every result as record.json.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "common/stop_watch.hpp"

namespace pennon {

class Record {
 public:
  explicit Record(std::string command_line) : command_line_(std::move(command_line)) {}

  /// The time of a phase, counted from the construction of the timer to its destruction.
  class Timer {
   public:
    Timer(Record& record, std::string phase) : record_(record), phase_(std::move(phase)) {}
    ~Timer();
    Timer(const Timer&) = delete;
    Timer& operator=(const Timer&) = delete;

   private:
    Record& record_;
    std::string phase_;
    StopWatch watch_;
  };
  [[nodiscard]] Timer time(std::string phase) { return {*this, std::move(phase)}; }

  /// A key of the case that had another value until the time t of the run; values as TOML.
  void add_change(double t, const std::string& key, const std::string& before,
                  const std::string& after);

  /// Wall seconds since the record was made.
  double wall_seconds() const;
  void write(const std::filesystem::path& file, int ranks) const;

 private:
  void add(const std::string& phase, double seconds);

  std::string command_line_;
  std::vector<std::pair<std::string, double>> phases_;
  struct Change {
    double t;
    std::string key, before, after;
  };
  std::vector<Change> changes_;
  StopWatch watch_;
};

}  // namespace pennon

#include "common/record/record.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <nlohmann/json.hpp>

#include "common/io/atomic_file.hpp"
#include "common/record/version.hpp"
#include "common/stop_watch.hpp"

namespace pennon {
namespace {

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::tm parts{};
  gmtime_r(&now, &parts);
  std::array<char, 32> text{};
  std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text.data();
}

// The largest resident set of this process, or of one that it started and waited for; Linux gives
// kilobytes.
long peak_memory_kilobytes() {
  rusage its_own{}, started{};
  getrusage(RUSAGE_SELF, &its_own);
  getrusage(RUSAGE_CHILDREN, &started);
  return std::max(its_own.ru_maxrss, started.ru_maxrss);
}

}  // namespace

Record::Timer::~Timer() {
  record_.add(phase_, watch_.seconds());
}

void Record::add(const std::string& phase, double seconds) {
  const auto found = std::ranges::find(phases_, phase, &std::pair<std::string, double>::first);
  if (found == phases_.end())
    phases_.emplace_back(phase, seconds);
  else
    found->second += seconds;
}

void Record::add_change(double t, const std::string& key, const std::string& before,
                        const std::string& after) {
  changes_.push_back({t, key, before, after});
}

double Record::wall_seconds() const {
  return watch_.seconds();
}

void Record::write(const std::filesystem::path& file, int ranks) const {
  nlohmann::ordered_json json;
  json["pennon"] = {{"version", version()}, {"commit", commit()}};
  json["command"] = command_line_;
  json["finished"] = utc_now();
  for (const auto& [name, number] : library_versions()) json["libraries"][name] = number;
  json["ranks"] = ranks;
  json["wall_s"]["total"] = wall_seconds();
  for (const auto& [phase, seconds] : phases_) json["wall_s"][phase] = seconds;
  for (const auto& [t, key, before, after] : changes_)
    json["changes"].push_back({{"t", t}, {"key", key}, {"before", before}, {"after", after}});
  json["peak_memory_kB"] = peak_memory_kilobytes();
  // A command line may hold a file name that is not UTF-8.
  write_file(file, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n");
}

}  // namespace pennon

#include "common/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace pennon {
namespace {

using namespace std::chrono_literals;
constexpr auto quiet_for = 1s;  // work shorter than this shows nothing
constexpr auto terminal_interval = 100ms;
constexpr auto log_interval = 10s;
constexpr int bar_width = 40;

std::string duration(double seconds) {
  const auto whole = std::lround(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

Progress::Progress(std::string what, std::int64_t total, bool is_shown)
    : what_(std::move(what)),
      total_(total),
      is_shown_(is_shown),
      is_terminal_(isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
  if (has_drawn_ && is_terminal_) fmt::print(stderr, "\r\033[K");
}

void Progress::advance_to(std::int64_t done, const std::function<std::string()>& detail) {
  if (!is_shown_ || total_ <= 0) return;
  const auto now = Clock::now();
  if (now - begin_ < quiet_for) return;
  if (now - last_shown_ < (is_terminal_ ? Clock::duration(terminal_interval) : log_interval))
    return;
  show(done, now, detail ? ", " + detail() : "");
}

void Progress::show(std::int64_t done, Clock::time_point now, const std::string& detail) {
  const double fraction =
      std::clamp(static_cast<double>(done) / static_cast<double>(total_), 0.0, 1.0);
  const double elapsed = std::chrono::duration<double>(now - begin_).count();
  const double done_now = fraction - static_cast<double>(begun_at_) / static_cast<double>(total_);
  const std::string left =
      (done_now > 0 ? duration(elapsed * (1 - fraction) / done_now) + " left" : "") + detail;
  if (is_terminal_) {
    const int filled = static_cast<int>(bar_width * fraction);
    fmt::print(stderr, "\r\033[K{} [{:=<{}}{: <{}}] {:3.0f} %  {}", what_, "", filled, "",
               bar_width - filled, 100 * fraction, left);
  } else {
    fmt::print(stderr, "{}: {:.0f} %, {}\n", what_, 100 * fraction, left);
  }
  std::fflush(stderr);
  has_drawn_ = true;
  last_shown_ = now;
}

}  // namespace pennon

/// What is written to standard error while it lives, on a terminal or in a log.
#pragma once

#include <fcntl.h>
#include <pty.h>
#include <unistd.h>

#include <array>
#include <stdexcept>
#include <string>

namespace pennon::test {

class CapturedErrors {
 public:
  enum class Target { terminal, log };

  explicit CapturedErrors(Target target) : saved_(dup(STDERR_FILENO)) {
    std::array<int, 2> ends{};
    const int failure = target == Target::terminal
                            ? openpty(&ends[0], &ends[1], nullptr, nullptr, nullptr)
                            : pipe(ends.data());
    if (failure != 0) throw std::runtime_error("standard error cannot be captured");
    reading_ = ends[0];
    fcntl(reading_, F_SETFL, O_NONBLOCK);
    dup2(ends[1], STDERR_FILENO);
    close(ends[1]);
  }
  ~CapturedErrors() {
    dup2(saved_, STDERR_FILENO);
    close(saved_);
    close(reading_);
  }
  CapturedErrors(const CapturedErrors&) = delete;
  CapturedErrors& operator=(const CapturedErrors&) = delete;

  /// What was written since the last call.
  std::string text() const {
    std::string text;
    std::array<char, 4096> block{};
    for (ssize_t count = 0; (count = read(reading_, block.data(), block.size())) > 0;)
      text.append(block.data(), static_cast<std::size_t>(count));
    return text;
  }

 private:
  int saved_;
  int reading_ = -1;
};

}  // namespace pennon::test

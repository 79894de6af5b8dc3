#include "common/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <string>
#include <system_error>
#include <vector>

#include "common/errors.hpp"
#include "common/io/running_process.hpp"

namespace pennon {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(),
                              std::generic_category().message(error)));
}

constexpr std::size_t random_digits = 16;
constexpr std::string_view temporary_mark = ".tmp";

// The process in a temporary name; 0: the name is none.
pid_t process_of(const std::string& name) {
  const std::size_t mark = name.rfind(temporary_mark);
  const std::size_t dash = name.rfind('-', mark);
  if (!name.starts_with('.') || mark == std::string::npos || dash == std::string::npos) return 0;
  const std::size_t dot = name.rfind('.', dash);
  const auto is_made_of = [&](std::size_t begin, std::size_t end, int (*kind)(int)) {
    return begin < end && std::all_of(name.begin() + static_cast<std::ptrdiff_t>(begin),
                                      name.begin() + static_cast<std::ptrdiff_t>(end),
                                      [kind](unsigned char c) { return kind(c) != 0; });
  };
  if (dot == std::string::npos || !is_made_of(dot + 1, dash, std::isdigit) ||
      mark - dash - 1 != random_digits || !is_made_of(dash + 1, mark, std::isxdigit))
    return 0;
  return static_cast<pid_t>(std::strtol(name.c_str() + dot + 1, nullptr, 10));
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path final_path)
    : final_(std::move(final_path)), temporary_(temporary_name(final_)) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!is_finished_) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::finish() {
  const int file = open(temporary_.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (file < 0) fail(temporary_, errno);
  const int failure = fsync(file) == 0 ? 0 : errno;
  close(file);
  if (failure != 0) fail(temporary_, failure);
  std::error_code error;
  std::filesystem::rename(temporary_, final_, error);
  if (error) fail(final_, error.value());
  is_finished_ = true;
}

std::filesystem::path temporary_name(const std::filesystem::path& final_path) {
  std::random_device source;
  const std::uint64_t number = (static_cast<std::uint64_t>(source()) << 32) | source();
  return final_path.parent_path() / fmt::format(".{}.{}-{:0{}x}{}{}", final_path.stem().string(),
                                                getpid(), number, random_digits, temporary_mark,
                                                final_path.extension().string());
}

void remove_stale_temporaries(const std::filesystem::path& folder) {
  std::error_code ignored;
  std::vector<std::filesystem::path> stale;
  for (const auto& entry : std::filesystem::directory_iterator(folder, ignored)) {
    const pid_t process = process_of(entry.path().filename().string());
    if (process > 0 && !is_running(process)) stale.push_back(entry.path());
  }
  for (const std::filesystem::path& file : stale) std::filesystem::remove(file, ignored);
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  const int descriptor =
      open(file.temporary().c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0666);
  if (descriptor < 0) fail(path, errno);
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count <= 0) {
      const int error = count == 0 ? ENOSPC : errno;
      if (error == EINTR) continue;
      close(descriptor);
      fail(path, error);
    }
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  if (close(descriptor) != 0) fail(path, errno);
  file.finish();
}

}  // namespace pennon

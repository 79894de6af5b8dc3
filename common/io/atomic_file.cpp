#include "common/io/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "common/errors.hpp"

namespace pennon {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, int error) {
  throw FileError(fmt::format("{} cannot be written: {}", path.string(),
                              std::generic_category().message(error)));
}

std::filesystem::path temporary_name(const std::filesystem::path& final_path) {
  return final_path.parent_path() / fmt::format(".{}.{}.tmp{}", final_path.stem().string(),
                                                getpid(), final_path.extension().string());
}

}  // namespace

AtomicFile::AtomicFile(std::filesystem::path final_path)
    : final_(std::move(final_path)), temporary_(temporary_name(final_)) {}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!is_finished_) std::filesystem::remove(temporary_, ignored);
}

void AtomicFile::finish() {
  const int file = open(temporary_.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) fail(temporary_, errno);
  const int failure = fsync(file) == 0 ? 0 : errno;
  close(file);
  if (failure != 0) fail(temporary_, failure);
  std::error_code error;
  std::filesystem::rename(temporary_, final_, error);
  if (error) fail(final_, error.value());
  is_finished_ = true;
}

void write_file(const std::filesystem::path& path, std::string_view text) {
  AtomicFile file(path);
  const int descriptor =
      open(file.temporary().c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_CLOEXEC, 0666);
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

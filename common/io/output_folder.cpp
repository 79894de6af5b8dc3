#include "common/io/output_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"

namespace pennon {
namespace {

// As much as the small files of any run, so that a full disk is met by the probe and not by them.
constexpr std::size_t probe_bytes = 1 << 18;

std::string system_message(int error) {
  return std::generic_category().message(error);
}

// Writes and removes a file in the folder; returns the system's error number, or 0.
int probe(const std::filesystem::path& folder) {
  const std::string name = temporary_name(folder / "probe").string();
  const int file = ::open(name.c_str(), O_CREAT | O_EXCL | O_NOFOLLOW | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  constexpr std::array<char, 4096> block{};
  int error = 0;
  for (std::size_t written = 0; written < probe_bytes && error == 0; written += block.size()) {
    const ssize_t count = ::write(file, block.data(), block.size());
    if (count < 0)
      error = errno;
    else if (static_cast<std::size_t>(count) < block.size())
      error = ENOSPC;
  }
  if (::close(file) != 0 && error == 0) error = errno;
  ::unlink(name.c_str());
  return error;
}

}  // namespace

OutputFolder::OutputFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);
  if (error)
    throw FileError(
        fmt::format("the output folder {} cannot be made: {}; choose another with --output",
                    folder_.string(), error.message()));
  if (const int failure = probe(folder_))
    throw FileError(
        fmt::format("the output folder {} cannot be written to: {}; choose another with --output",
                    folder_.string(), system_message(failure)));
}

void OutputFolder::require_space(std::uintmax_t bytes, const std::string& what) const {
  std::error_code error;
  const std::filesystem::space_info space = std::filesystem::space(folder_, error);
  if (error || space.available >= bytes) return;
  constexpr double gigabyte = 1e9;
  throw FileError(fmt::format(
      "{} needs {:.3g} GB in the output folder {}, where {:.3g} GB are free; choose another with "
      "--output, or ask for less",
      what, static_cast<double>(bytes) / gigabyte, folder_.string(),
      static_cast<double>(space.available) / gigabyte));
}

}  // namespace pennon

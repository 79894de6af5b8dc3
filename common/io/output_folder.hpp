/// The folder a run writes to. Made and tried before the work starts, so that an unwritable or full
/// place is found at once and not after an hour.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace pennon {

class OutputFolder {
 public:
  /// Makes the folder and those above it, and writes a probe file into it.
  /// Throws FileError that names the folder and what the system said.
  explicit OutputFolder(std::filesystem::path folder);

  const std::filesystem::path& path() const { return folder_; }
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }

  /// Throws FileError if the file system has less than `bytes` free; `what` is to be written.
  void require_space(std::uintmax_t bytes, const std::string& what) const;

 private:
  std::filesystem::path folder_;
};

}  // namespace pennon

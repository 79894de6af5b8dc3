/// Files that are written whole or not at all: under a temporary name beside the final one, synced
/// to the disk, then renamed. A killed run leaves no half-written file under a final name.
#pragma once

#include <filesystem>
#include <string_view>

namespace pennon {

class AtomicFile {
 public:
  /// Nothing is written yet: write to temporary(), then call finish().
  explicit AtomicFile(std::filesystem::path final_path);
  /// Removes the temporary file if finish() was not reached.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Has the final name's ending, since some writers choose the format by it.
  const std::filesystem::path& temporary() const { return temporary_; }
  const std::filesystem::path& final_path() const { return final_; }
  /// Syncs the temporary file and gives it its final name. Throws FileError.
  void finish();

 private:
  std::filesystem::path final_;
  std::filesystem::path temporary_;
  bool is_finished_ = false;
};

/// Writes a whole text file at once. Throws FileError that names it and what the system said.
void write_file(const std::filesystem::path& path, std::string_view text);

}  // namespace pennon

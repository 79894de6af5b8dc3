/// Files that are written whole or not at all: under a temporary name beside the final one, synced
/// to the disk, then renamed. A killed run leaves no half-written file under a final name.
///
/// A temporary name is hidden and cannot be guessed: ".<stem>.<process>-<16 hexadecimal
/// digits>.tmp" with the final name's ending. It is opened with O_EXCL and O_NOFOLLOW, so that
/// nothing that another user laid there is written to.
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

/// A name for a temporary file beside `final_path`, as above.
std::filesystem::path temporary_name(const std::filesystem::path& final_path);

/// Removes the temporary files in the folder whose process is gone: what a killed run left. The
/// folder must be locked, so that no process of another machine writes there.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace pennon

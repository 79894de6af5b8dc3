/// One process at a time writes results into a folder: the file ".lock" in it names the process and
/// the machine that do.
#pragma once

#include <filesystem>

namespace pennon {

class FolderLock {
 public:
  /// Locks the folder, which is there. A lock whose process has ended on this machine is taken
  /// over. `is_forced`: so is one of another machine, of which that cannot be known. Throws
  /// InputError that names the folder, the process and its machine where another holds it, and
  /// FileError where the file cannot be made.
  FolderLock(const std::filesystem::path& folder, bool is_forced);
  /// Unlocks.
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  std::filesystem::path file_;
  int descriptor_ = -1;
};

}  // namespace pennon

/// A disk that is full after some bytes, for a process of its own (see child_process.hpp).
#pragma once

#include <sched.h>
#include <sys/mount.h>
#include <sys/resource.h>

#include <fmt/format.h>
#include <csignal>
#include <filesystem>

namespace pennon::test {

/// Lets no file of the calling process grow beyond so many bytes.
inline void limit_file_size(unsigned long bytes) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_FSIZE, &limit);
}

/// Lets the calling process meet its end of space within `folder`: by a small file system mounted
/// there where it may mount, else by a limit on the size of files. Only this process sees it.
inline void have_small_disk(const std::filesystem::path& folder, unsigned long bytes) {
  const bool is_mounted =
      unshare(CLONE_NEWNS) == 0 && mount("none", "/", nullptr, MS_REC | MS_PRIVATE, nullptr) == 0 &&
      mount("tmpfs", folder.c_str(), "tmpfs", 0, fmt::format("size={}", bytes).c_str()) == 0;
  if (!is_mounted) limit_file_size(bytes);
}

}  // namespace pennon::test

#include "common/io/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <sstream>
#include <string>
#include <system_error>

#include "common/errors.hpp"
#include "common/io/running_process.hpp"

namespace pennon {
namespace {

std::string this_host() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "unknown";
}

// Who wrote the lock.
struct Holder {
  pid_t process = 0;
  std::string host;
};

Holder holder_in(int descriptor) {
  std::array<char, 512> text{};
  const ssize_t count = pread(descriptor, text.data(), text.size() - 1, 0);
  Holder holder;
  if (count > 0) std::istringstream(text.data()) >> holder.process >> holder.host;
  return holder;
}

// Whether the path still leads to the file that is open: its holder may have removed it since.
bool is_at(const std::filesystem::path& path, int descriptor) {
  struct stat of_path {
  }, of_file{};
  return lstat(path.c_str(), &of_path) == 0 && fstat(descriptor, &of_file) == 0 &&
         of_path.st_ino == of_file.st_ino && of_path.st_dev == of_file.st_dev;
}

[[noreturn]] void refuse(const std::filesystem::path& folder, const Holder& holder,
                         const std::string& advice) {
  throw InputError(folder.string(),
                   fmt::format("is being written to by process {} on {}; {}", holder.process,
                               holder.host.empty() ? "this machine" : holder.host, advice));
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, bool is_forced)
    : file_(folder / ".lock") {
  const auto fail = [this](int error) {
    if (descriptor_ >= 0) close(descriptor_);
    throw FileError(fmt::format("{} cannot be locked: {}", file_.string(),
                                std::generic_category().message(error)));
  };
  constexpr const char* wait = "wait until it has ended, or choose another folder with --output";
  // The kernel's lock ends with its process; what the file says is for people, and for folders that
  // several machines share without sharing locks.
  bool has_kernel_lock = false;
  for (;;) {
    descriptor_ = open(file_.c_str(), O_CREAT | O_RDWR | O_NOFOLLOW | O_CLOEXEC, 0644);
    if (descriptor_ < 0) fail(errno);
    has_kernel_lock = flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (!has_kernel_lock && errno == EWOULDBLOCK) {
      const Holder holder = holder_in(descriptor_);
      close(descriptor_);
      refuse(folder, holder, wait);
    }
    if (is_at(file_, descriptor_)) break;
    close(descriptor_);
  }
  const Holder before = holder_in(descriptor_);
  const bool is_here = before.host.empty() || before.host == this_host();
  if (!is_here && !is_forced) {
    close(descriptor_);
    refuse(folder, before,
           fmt::format("if it has ended, --force goes on, or remove {}", file_.string()));
  }
  if (is_here && !has_kernel_lock && is_running(before.process)) {
    close(descriptor_);
    refuse(folder, before, wait);
  }
  const std::string text = fmt::format("{} {}\n", getpid(), this_host());
  if (ftruncate(descriptor_, 0) != 0 ||
      pwrite(descriptor_, text.data(), text.size(), 0) != static_cast<ssize_t>(text.size()))
    fail(errno == 0 ? ENOSPC : errno);
}

FolderLock::~FolderLock() {
  unlink(file_.c_str());
  close(descriptor_);
}

}  // namespace pennon

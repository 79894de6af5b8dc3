/// Whether what a process left in a folder is still its own.
#pragma once

#include <signal.h>

#include <cerrno>

namespace pennon {

/// Whether there is a process of this machine with the number, of whatever user.
inline bool is_running(pid_t process) {
  return process > 0 && (kill(process, 0) == 0 || errno != ESRCH);
}

}  // namespace pennon

/// Child programs: gnuplot, which draws the pictures, and pennon-global, which finds the global
/// modes.
///
/// Kept by hand, in system calls, because what Debian 12 packages does not serve. Boost.Process
/// (1.74) needs the compiled Boost.Filesystem, waits for a child's words in an Asio loop that does
/// not look for our interrupts, and is the version 1 that its authors have replaced since; GLib and
/// Qt are far larger than the task; posix_spawn, which is the system's own, cannot tie a child's
/// life to its parent's.
///
/// A child is started without a shell. It ends (SIGTERM) when its parent ends, even where that is
/// killed. Between fork and exec only functions are called that are safe after a fork of a program
/// with threads.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pennon {

struct ChildProgram {
  std::filesystem::path program;                     ///< a path, as find_program() gives it
  std::vector<std::string> arguments = {};           ///< without the program's name
  std::optional<std::string_view> input = {};        ///< of its standard input; none: the parent's
  std::optional<std::filesystem::path> output = {};  ///< of its standard output; none: the parent's
  std::optional<std::string_view> data = {};         ///< what it reads from data_file
  std::vector<std::string> unset = {};               ///< environment variables that it does not get
  /// Whether it is sent SIGTERM once the user has asked pennon to stop (common/interrupt.hpp), and
  /// two seconds later SIGKILL.
  bool is_interruptible = false;
  /// Is handed each line that the child writes to its standard error, without its end, as it comes;
  /// those for which it returns true are no messages. None: all are.
  std::function<bool(std::string_view line)> takes_line = {};
};

/// The name under which a child may open its data, as often as it likes, from the beginning.
inline constexpr const char* data_file = "/proc/self/fd/3";

/// How a child ended: by itself with an exit status, or by a signal.
struct ChildEnd {
  int exit_status = 0;
  int signal = 0;        ///< 0: none
  std::string messages;  ///< what it wrote to its standard error

  bool is_success() const { return exit_status == 0 && signal == 0; }
};

/// The path of an executable program: of `name` itself where it has a slash, else the first of that
/// name in the folders of PATH; none where there is none.
std::optional<std::filesystem::path> find_program(const std::string& name);

/// Starts the program and waits for its end. `output` is made anew. Throws FileError, which names
/// the program and what the system said, where it cannot be started, its input or data cannot be
/// kept in a scratch file, or `output` cannot be written.
ChildEnd run_program(const ChildProgram&);

}  // namespace pennon

#include "common/process/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include "common/errors.hpp"
#include "common/interrupt.hpp"

namespace pennon {
namespace {

[[noreturn]] void fail(const std::string& what, int error) {
  throw FileError(fmt::format("{}: {}", what, std::generic_category().message(error)));
}

// An open file, closed with its owner and at an exec.
class Descriptor {
 public:
  explicit Descriptor(int number = -1) : number_(number) {}
  Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(number_, other.number_);
    return *this;
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }
  int release() { return std::exchange(number_, -1); }
  int number() const { return number_; }
  bool is_open() const { return number_ >= 0; }

 private:
  int number_;
};

constexpr int data_stream = 3;

// The same file under a number above those that a child's streams get.
Descriptor moved_up(int file, const std::string& program) {
  const Descriptor low(file);
  Descriptor high(fcntl(low.number(), F_DUPFD_CLOEXEC, data_stream + 1));
  if (!high.is_open()) fail("too many files are open to start " + program, errno);
  return high;
}

struct Pipe {
  Descriptor to_read, to_write;

  explicit Pipe(const std::string& program) {
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("no pipe to " + program, errno);
    Descriptor second(ends[1]);
    to_read = moved_up(ends[0], program);
    to_write = moved_up(second.release(), program);
  }
};

// A file without a name that holds the text, at its beginning. Unlike a pipe it takes any length
// while nobody reads, and a child that ends early leaves nobody writing.
Descriptor scratch_with(std::string_view text, const std::string& program) {
  std::string name = (std::filesystem::temp_directory_path() / "pennon-XXXXXX").string();
  const int made = mkostemp(name.data(), O_CLOEXEC);
  if (made < 0) fail("no scratch file can be made for " + program, errno);
  unlink(name.c_str());
  Descriptor file = moved_up(made, program);
  while (!text.empty()) {
    const ssize_t count = write(file.number(), text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(fmt::format("the scratch file for {} cannot be written", program), errno);
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  lseek(file.number(), 0, SEEK_SET);
  return file;
}

Descriptor created(const std::filesystem::path& path, const std::string& program) {
  constexpr mode_t everyones = 0666;  // less what the user's umask takes away
  const int file =
      open(path.c_str(), O_CREAT | O_WRONLY | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, everyones);
  if (file < 0) fail(path.string() + " cannot be written", errno);
  return moved_up(file, program);
}

struct Streams {
  Descriptor input, output, data;
  Pipe messages;
};

// The words as execve() takes them; they must outlive the pointers.
std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

// This program's environment but for the variables of these names.
std::vector<std::string> environment_without(const std::vector<std::string>& names) {
  std::vector<std::string> kept;
  for (char** variable = environ; *variable != nullptr; ++variable) {
    const std::string_view text = *variable;
    if (std::ranges::find(names, text.substr(0, text.find('='))) == names.end())
      kept.emplace_back(text);
  }
  return kept;
}

// In the child: the file is this stream from now on, and stays open at the exec. All files that the
// parent opened have higher numbers, so that none is lost.
bool is_made_stream(const Descriptor& file, int stream) {
  return dup2(file.number(), stream) >= 0;
}

// In the child: becomes the program, or hands the error of the call that failed to the parent.
[[noreturn]] void become(const char* program, char* const* words, char* const* environment,
                         const Streams& streams, pid_t parent, int failures) {
  const bool is_ready =
      prctl(PR_SET_PDEATHSIG, SIGTERM) == 0 && getppid() == parent &&
      (!streams.input.is_open() || is_made_stream(streams.input, STDIN_FILENO)) &&
      (!streams.output.is_open() || is_made_stream(streams.output, STDOUT_FILENO)) &&
      (!streams.data.is_open() || is_made_stream(streams.data, data_stream)) &&
      is_made_stream(streams.messages.to_write, STDERR_FILENO);
  if (is_ready) execve(program, words, environment);
  const int error = errno;
  const ssize_t told = write(failures, &error, sizeof error);
  _exit(told == sizeof error ? 127 : 126);
}

pid_t start(const ChildProgram& asked, const Streams& streams) {
  const std::string program = asked.program.string();
  std::vector<std::string> words = asked.arguments;
  words.insert(words.begin(), program);
  std::vector<std::string> variables = environment_without(asked.unset);
  const std::vector<char*> arguments = pointers_to(words), environment = pointers_to(variables);
  Pipe failures(program);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail(program + " cannot be started", errno);
  if (child == 0)
    become(program.c_str(), arguments.data(), environment.data(), streams, parent,
           failures.to_write.number());
  failures.to_write.close();
  int error = 0;
  ssize_t count = 0;
  do count = read(failures.to_read.number(), &error, sizeof error);
  while (count < 0 && errno == EINTR);
  if (count == 0) return child;  // the exec closed the pipe
  waitpid(child, nullptr, 0);
  fail(program + " cannot be started", error);
}

// The lines of a child that come piece by piece.
class Lines {
 public:
  explicit Lines(const ChildProgram& asked) : takes_line_(asked.takes_line) {}

  void add(std::string_view piece) {
    if (!takes_line_) {
      kept_ += piece;
      return;
    }
    begun_ += piece;
    for (std::size_t end = begun_.find('\n'); end != std::string::npos; end = begun_.find('\n')) {
      const std::string line = begun_.substr(0, end);
      begun_.erase(0, end + 1);
      if (!takes_line_(line)) kept_ += line + '\n';
    }
  }
  /// What was not taken.
  std::string rest() const { return kept_ + begun_; }

 private:
  const std::function<bool(std::string_view)>& takes_line_;
  std::string kept_, begun_;
};

// What the child says until it closes its standard error.
std::string read_messages(int pipe_end, pid_t child, const ChildProgram& asked) {
  const bool is_interruptible = asked.is_interruptible;
  Lines lines(asked);
  std::array<char, 4096> buffer{};
  constexpr int milliseconds_between_looks = 200;
  constexpr int looks_of_grace = 10;
  int looks = 0;  // since the interrupt
  for (;;) {
    pollfd waiting{pipe_end, POLLIN, 0};
    if (is_interruptible && is_interrupted() && looks <= looks_of_grace) {
      if (looks == 0) kill(child, SIGTERM);
      if (looks == looks_of_grace) kill(child, SIGKILL);
      ++looks;
    }
    if (poll(&waiting, 1, milliseconds_between_looks) <= 0) continue;
    const ssize_t count = read(pipe_end, buffer.data(), buffer.size());
    if (count > 0)
      lines.add({buffer.data(), static_cast<std::size_t>(count)});
    else if (count == 0 || errno != EINTR)
      return lines.rest();
  }
}

bool is_executable(const std::filesystem::path& path) {
  std::error_code ignored;
  return std::filesystem::is_regular_file(path, ignored) && access(path.c_str(), X_OK) == 0;
}

}  // namespace

std::optional<std::filesystem::path> find_program(const std::string& name) {
  if (name.find('/') != std::string::npos) {
    if (is_executable(name)) return name;
    return std::nullopt;
  }
  const char* folders = std::getenv("PATH");
  std::istringstream path(folders != nullptr ? folders : "/usr/bin:/bin");
  for (std::string folder; std::getline(path, folder, ':');) {
    std::filesystem::path file = std::filesystem::path(folder.empty() ? "." : folder) / name;
    if (is_executable(file)) return file;
  }
  return std::nullopt;
}

ChildEnd run_program(const ChildProgram& asked) {
  const std::string program = asked.program.string();
  Streams streams{asked.input ? scratch_with(*asked.input, program) : Descriptor(),
                  asked.output ? created(*asked.output, program) : Descriptor(),
                  asked.data ? scratch_with(*asked.data, program) : Descriptor(), Pipe(program)};
  const pid_t child = start(asked, streams);
  streams.messages.to_write.close();
  ChildEnd end;
  end.messages = read_messages(streams.messages.to_read.number(), child, asked);
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) fail(program + " was lost", errno);
  if (WIFSIGNALED(status))
    end.signal = WTERMSIG(status);
  else
    end.exit_status = WEXITSTATUS(status);
  return end;
}

}  // namespace pennon

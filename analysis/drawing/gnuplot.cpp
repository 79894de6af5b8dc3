#include "analysis/drawing/gnuplot.hpp"

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <system_error>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/utf8.hpp"

namespace pennon::analysis {
namespace {

std::string system_words(int error) {
  return std::generic_category().message(error);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

// A file for reading and writing, without a name, gone when closed.
File scratch() {
  File file(std::tmpfile(), std::fclose);
  if (file == nullptr)
    throw FileError("no scratch file can be made for gnuplot: " + system_words(errno));
  return file;
}

File scratch_with(std::string_view text) {
  File file = scratch();
  if (std::fwrite(text.data(), 1, text.size(), file.get()) != text.size() ||
      std::fflush(file.get()) != 0)
    throw FileError("the scratch file for gnuplot cannot be written: " + system_words(errno));
  std::rewind(file.get());
  return file;
}

std::string contents(const File& file) {
  std::rewind(file.get());
  std::string text;
  std::array<char, 4096> block{};
  while (const std::size_t count = std::fread(block.data(), 1, block.size(), file.get()))
    text.append(block.data(), count);
  return text;
}

File create(const std::filesystem::path& path) {
  File file(std::fopen(path.c_str(), "wb"), std::fclose);
  if (file == nullptr)
    throw FileError(fmt::format("{} cannot be written: {}", path.string(), system_words(errno)));
  return file;
}

// The three standard streams of the child.
class Streams {
 public:
  Streams(const File& in, const File& out, const File& messages) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_adddup2(&actions_, fileno(in.get()), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, fileno(out.get()), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&actions_, fileno(messages.get()), STDERR_FILENO);
  }
  ~Streams() { posix_spawn_file_actions_destroy(&actions_); }
  Streams(const Streams&) = delete;
  Streams& operator=(const Streams&) = delete;
  const posix_spawn_file_actions_t* raw() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

// Starts gnuplot and waits for its end; returns its exit status.
int run(const Streams& streams) {
  // -d: without the user's ~/.gnuplot, which could change any picture.
  std::array<char, 8> program{"gnuplot"};
  std::array<char, 3> defaults{"-d"};
  const std::array<char*, 3> arguments = {program.data(), defaults.data(), nullptr};
  pid_t child = 0;
  const int error =
      posix_spawnp(&child, program.data(), streams.raw(), nullptr, arguments.data(), environ);
  if (error == ENOENT)
    throw FileError("gnuplot, which draws the pictures, was not found: install gnuplot-nox");
  if (error != 0) throw FileError("gnuplot cannot be started: " + system_words(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw FileError("gnuplot was lost: " + system_words(errno));
  return status;
}

bool file_ends_with(const std::filesystem::path& file, std::string_view ending) {
  std::ifstream stream(file, std::ios::binary | std::ios::ate);
  if (!stream || stream.tellg() < static_cast<std::streamoff>(ending.size())) return false;
  stream.seekg(-static_cast<std::streamoff>(ending.size()), std::ios::end);
  std::string last(ending.size(), '\0');
  stream.read(last.data(), static_cast<std::streamsize>(last.size()));
  return last == ending;
}

}  // namespace

std::string quoted_text(std::string_view text) {
  std::string result = "'";
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = utf8_length(text);
    if (length == 0 || first < 0x20 || first == 0x7f)
      result += ' ';
    else if (first == '\'')
      result += "\u2019";
    else
      result += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return result + "'";
}

void run_gnuplot(std::string_view script, const std::filesystem::path& picture,
                 std::string_view ending) {
  AtomicFile file(picture);
  const File input = scratch_with(script);
  const File output = create(file.temporary());
  const File messages = scratch();
  const int status = run(Streams(input, output, messages));
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0 || !file_ends_with(file.temporary(), ending)) {
    const std::string words = contents(messages);
    throw FileError(fmt::format("gnuplot could not draw {}: {}", picture.string(),
                                words.empty() ? "the picture is not whole" : words));
  }
  file.finish();
}

}  // namespace pennon::analysis

#include "app/global_process.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/atomic_file.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::app {
namespace {

struct ProcessEnd {
  int status = 0;      // exit status; 128 and more: a signal
  std::string errors;  // what it said
};

[[noreturn]] void fail(const std::string& what) {
  throw FileError(fmt::format("{}: {}", what, std::strerror(errno)));
}

// What the child says until its end. Passes an interrupt on, again and again until the child obeys:
// a second one ends it at once.
std::string read_all(int pipe_end, pid_t child) {
  std::string text;
  std::array<char, 4096> buffer{};
  constexpr int patience = 200;  // milliseconds
  for (;;) {
    pollfd waiting{pipe_end, POLLIN, 0};
    if (poll(&waiting, 1, patience) <= 0) {
      if (is_interrupted()) kill(child, SIGTERM);
      continue;
    }
    const ssize_t count = read(pipe_end, buffer.data(), buffer.size());
    if (count > 0)
      text.append(buffer.data(), static_cast<std::size_t>(count));
    else if (count == 0 || errno != EINTR)
      return text;
  }
}

// Runs a program, the first of the words, to its end, with its standard error taken down.
ProcessEnd run_program(const std::vector<std::string>& words) {
  std::array<int, 2> pipe_ends{};
  if (pipe(pipe_ends.data()) != 0) fail("no pipe to pennon-global");
  std::vector<const char*> arguments;
  arguments.reserve(words.size() + 1);
  for (const std::string& word : words) arguments.push_back(word.c_str());
  arguments.push_back(nullptr);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) fail("pennon-global cannot be started");
  if (child == 0) {
    // It ends with the one that waits for it, even where that is killed.
    if (prctl(PR_SET_PDEATHSIG, SIGTERM) != 0 || getppid() != parent) _exit(127);
    dup2(pipe_ends[1], STDERR_FILENO);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    execv(arguments[0], const_cast<char* const*>(arguments.data()));
    _exit(127);
  }
  close(pipe_ends[1]);
  ProcessEnd end;
  end.errors = read_all(pipe_ends[0], child);
  close(pipe_ends[0]);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  end.status = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return end;
}

std::filesystem::path program_beside_this() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  std::filesystem::path program = folder / "pennon-global";
  if (access(program.c_str(), X_OK) != 0)
    throw FileError(fmt::format(
        "pennon-global, the program that finds global modes, is not beside pennon in {}",
        folder.string()));
  return program;
}

// The sentence without the name of the program before it, and without what mpiexec says, between
// lines of dashes, of a program that failed; where mpiexec alone speaks, what it says.
std::string sentence_of(std::string errors) {
  constexpr std::string_view name = "pennon: ", dashes = "\n-----";
  if (errors.starts_with(dashes.substr(1))) errors.erase(0, errors.find('\n') + 1);
  errors = errors.substr(0, errors.find(dashes));
  while (!errors.empty() && errors.back() == '\n') errors.pop_back();
  return errors.starts_with(name) ? errors.substr(name.size()) : errors;
}

// As it was before it was printed.
InputError input_error(const std::string& sentence) {
  const std::size_t colon = sentence.find(": ");
  if (colon == std::string::npos) return {"modes.global", sentence};
  return {sentence.substr(0, colon), sentence.substr(colon + 2)};
}

void raise(const ProcessEnd& end) {
  const std::string sentence = sentence_of(end.errors);
  stop_if_interrupted("no global modes were written");
  if (end.status == 2) throw input_error(sentence);
  if (end.status == 3) throw SolverError(sentence);
  if (end.status >= 128)
    throw std::runtime_error(
        fmt::format("pennon-global was ended by signal {}, perhaps for want of memory; a smaller "
                    "modes.global.n_rho or n_theta needs less. {}",
                    end.status - 128, sentence));
  if (end.status != 0) throw std::runtime_error("pennon-global: " + sentence);
}

}  // namespace

void expect_one_rank() {
  if (ranks::count() > 1)
    throw InputError("mpiexec",
                     fmt::format("started {0} ranks, but pennon itself finds global modes on one; "
                                 "modes.global.ranks = {0} shares the work",
                                 ranks::count()));
}

nlohmann::ordered_json solve_global_modes(const modes::global::Problem& problem,
                                          const OutputFolder& folder) {
  const std::filesystem::path asked = folder / "global_problem.toml",
                              answered = folder / "global_modes.json";
  write_file(asked, "# What pennon-global solved.\n" + resolved_text(problem.schema));
  std::vector<std::string> words = {program_beside_this(), asked, answered};
  const std::int64_t shared_by = problem.settings.ranks;
  if (shared_by > 1) {
    if (access(PENNON_MPIEXEC, X_OK) != 0)
      throw InputError("modes.global.ranks", fmt::format("{} ranks need {}, which is not there",
                                                         shared_by, PENNON_MPIEXEC));
    words.insert(words.begin(), {PENNON_MPIEXEC, "-n", std::to_string(shared_by)});
  }
  raise(run_program(words));
  std::ifstream file(answered);
  return nlohmann::ordered_json::parse(file);
}

}  // namespace pennon::app

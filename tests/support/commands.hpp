/// pennon as a user starts it: its exit code, what it says, and a folder for what it writes.
#pragma once

#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/source_folder.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {

inline const std::filesystem::path source = source_folder();
inline const std::filesystem::path table_1_cases = source / "data/cases/table1";

constexpr int done = 0, other = 1, bad_input = 2, not_converged = 3;

/// Starts a program with its output in files; the caller waits for it.
inline pid_t start_program(const std::vector<std::string>& words, const std::filesystem::path& out,
                           const std::filesystem::path& err) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (const auto& [file, descriptor] :
       {std::pair(out, STDOUT_FILENO), std::pair(err, STDERR_FILENO)})
    dup2(open(file.c_str(), O_CREAT | O_WRONLY | O_TRUNC, 0600), descriptor);
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  execv(argv[0], argv.data());
  _exit(127);
}

struct Outcome {
  int status = -1;  ///< exit code, or minus the signal
  std::string out, err;
};

class Commands : public testing::Test {
 protected:
  Outcome finish(pid_t child) {
    int status = 0;
    waitpid(child, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
            read_text(folder_ / "out.txt"), read_text(folder_ / "err.txt")};
  }
  pid_t start_in_background(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), PENNON_EXECUTABLE);
    return start_program(arguments, folder_ / "out.txt", folder_ / "err.txt");
  }
  Outcome pennon(const std::vector<std::string>& arguments) {
    return finish(start_in_background(arguments));
  }
  /// What Open MPI asks for from a superuser, and on fewer cores than ranks.
  static void allow_ranks() {
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
    setenv("OMPI_MCA_rmaps_base_oversubscribe", "1", 1);
  }
  /// mpiexec -n ranks pennon ...
  pid_t start_in_background_on(int ranks, std::vector<std::string> arguments) {
    allow_ranks();
    arguments.insert(arguments.begin(),
                     {PENNON_MPIEXEC, "-n", std::to_string(ranks), PENNON_EXECUTABLE});
    return start_program(arguments, folder_ / "out.txt", folder_ / "err.txt");
  }
  /// The pennon that mpiexec, a child, has started: the last one.
  static pid_t child_of(pid_t parent) {
    namespace fs = std::filesystem;
    const std::string process = "/proc/" + std::to_string(parent);
    std::ifstream children(process + "/task/" + std::to_string(parent) + "/children");
    pid_t child = parent;
    for (pid_t each = 0; children >> each;)
      if (fs::read_symlink("/proc/" + std::to_string(each) + "/exe") ==
          fs::canonical(PENNON_EXECUTABLE))
        child = each;
    return child;
  }
  Outcome pennon_on(int ranks, const std::vector<std::string>& arguments) {
    return finish(start_in_background_on(ranks, arguments));
  }
  /// How a run of `arguments` in results(folder), on so many ranks, ends at a signal, a moment
  /// after it began.
  Outcome pennon_stopped(int signal, int ranks, std::vector<std::string> arguments,
                         const std::string& folder) {
    arguments.insert(arguments.end(), {"--output", results(folder)});
    // Open MPI passes SIGTERM on after so many seconds, and kills after as many more.
    setenv("OMPI_MCA_odls_base_sigkill_timeout", "1", 1);
    const pid_t child =
        ranks == 1 ? start_in_background(arguments) : start_in_background_on(ranks, arguments);
    while (!std::filesystem::exists(results(folder) + "/case.resolved.toml") &&
           waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    unsetenv("OMPI_MCA_odls_base_sigkill_timeout");
    kill(child, signal);
    return finish(child);
  }
  /// Runs `arguments` in results(folder), kills the run once it has left a checkpoint, and goes on
  /// from there.
  Outcome pennon_killed_and_continued(std::vector<std::string> arguments,
                                      const std::string& folder) {
    arguments.insert(arguments.end(), {"--output", results(folder)});
    const std::string checkpoint = results(folder) + "/checkpoint.h5";
    const pid_t child = start_in_background(arguments);
    while (!std::filesystem::exists(checkpoint) && waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    kill(child, SIGKILL);
    waitpid(child, nullptr, 0);
    arguments.insert(arguments.end(), {"--restart", checkpoint});
    return pennon(arguments);
  }
  /// Runs `arguments` whole and without a checkpoint on its way, in results("whole"), and killed
  /// and continued, in results("parts"): both come to their end, with the same bits in history.csv.
  void expect_same_after_termination(const std::vector<std::string>& arguments, Outcome& whole,
                                     Outcome& parts) {
    std::vector<std::string> uninterrupted = arguments;
    uninterrupted.insert(uninterrupted.end(),
                         {"--set", "dns.output.checkpoint_interval=0", "--set",
                          "dns.output.checkpoint_minutes=0", "--output", results("whole")});
    whole = pennon(uninterrupted);
    ASSERT_EQ(whole.status, done) << whole.err;
    parts = pennon_killed_and_continued(arguments, "parts");
    ASSERT_EQ(parts.status, done) << parts.err;
    EXPECT_EQ(read_text(results("parts") + "/history.csv"),
              read_text(results("whole") + "/history.csv"));
  }
  std::string results(const std::string& name = "results") const {
    return (folder_ / name).string();
  }

  TemporaryFolder folder_;
};

}  // namespace pennon::test

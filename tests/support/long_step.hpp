/// A simulation that is told to end within a step that takes long.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <thread>

#include "common/io/hdf5.hpp"
#include "tests/support/commands.hpp"

namespace pennon::test {

class LongStep : public Commands {
 protected:
  using Words = std::vector<std::string>;

  std::string checkpoint_in(const std::string& folder) const {
    return results(folder) + "/checkpoint.h5";
  }
  void run_to_the_end(Words words, const std::string& folder, int ranks) {
    words.insert(words.end(), {"--quiet", "--output", results(folder)});
    const Outcome outcome = ranks == 1 ? pennon(words) : pennon_on(ranks, words);
    ASSERT_EQ(outcome.status, done) << outcome.err;
  }
  // Sends SIGTERM within the second step, once the checkpoint after the first is there.
  void stop_in_second_step(Words words, const std::string& folder, int ranks) {
    words.insert(words.end(), {"--output", results(folder)});
    setenv("OMPI_MCA_odls_base_sigkill_timeout", "5", 1);
    const pid_t child =
        ranks == 1 ? start_in_background(words) : start_in_background_on(ranks, words);
    unsetenv("OMPI_MCA_odls_base_sigkill_timeout");
    while (!std::filesystem::exists(checkpoint_in(folder)) && waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    t_ = hdf5::Reader(checkpoint_in(folder)).number("/", "t");
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    // mpiexec waits a second before it passes a signal on; to the ranks it comes at once from here.
    kill(ranks == 1 ? child : child_of(child), SIGTERM);
    const Outcome outcome = finish(child);
    EXPECT_EQ(outcome.status, other) << outcome.err;
    EXPECT_THAT(outcome.err, testing::HasSubstr("--restart")) << folder;
  }
  void expect_left(const Words& words, const std::string& name, int ranks) {
    ASSERT_NO_FATAL_FAILURE(run_to_the_end(words, name + "_whole", ranks));
    const std::string parts = name + "_parts";
    ASSERT_NO_FATAL_FAILURE(stop_in_second_step(words, parts, ranks));
    EXPECT_EQ(hdf5::Reader(checkpoint_in(parts)).number("/", "t"), t_)
        << "the second step was not left";
    Words rest = words;
    rest.insert(rest.end(), {"--restart", checkpoint_in(parts)});
    ASSERT_NO_FATAL_FAILURE(run_to_the_end(rest, parts, ranks));
    EXPECT_EQ(read_text(results(parts) + "/history.csv"),
              read_text(results(name + "_whole") + "/history.csv"));
  }

  double t_ = 0;  // after the first step
};

}  // namespace pennon::test

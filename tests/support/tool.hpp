/// The main() of the small programs beside the tests: words counted, faults said.
#pragma once

#include <fmt/format.h>

#include <exception>
#include <filesystem>

namespace pennon::test {

/// Calls work(argv) where there are as many words as `usage` names, the program's among them.
/// Returns the exit status.
template <class Work>
int run_tool(int argc, char** argv, int words, const char* usage, const Work& work) {
  if (argc != words) {
    fmt::print(stderr, "usage: {}\n", usage);
    return 2;
  }
  try {
    work(argv);
    return 0;
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}

}  // namespace pennon::test

/// What the declaration of the command line shows to a user.
#pragma once

#include <CLI/CLI.hpp>
#include <vector>

namespace pennon::app {

/// The commands of a program but those without a group, which its help does not show.
inline std::vector<const CLI::App*> shown_commands(const CLI::App& program) {
  return program.get_subcommands(
      [](const CLI::App* command) { return !command->get_group().empty(); });
}

}  // namespace pennon::app

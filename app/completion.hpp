/// The completion of the command line by a shell, made from its declaration.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace pennon::app {

/// A script for bash that completes the commands of `program`, their options, and names of files.
std::string bash_completion(const CLI::App& program);

}  // namespace pennon::app

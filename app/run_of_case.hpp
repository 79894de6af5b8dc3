/// A run of `pennon dns`, found again for a case.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "analysis/signal/run_context.hpp"
#include "app/case.hpp"

namespace pennon::app {

struct RunOfCase {
  std::filesystem::path folder;
  std::unique_ptr<Case> the_case;  ///< as it was run
  double wall_seconds = 0;
};

/// What its analysis takes from a case.
analysis::RunContext context_of(const Case&);

/// The folder of a run of `pennon dns`: the one given, or `dns` in it where that is a case's
/// folder.
std::filesystem::path folder_of_run(const std::filesystem::path& given);

/// The run in the folder that was asked for, or, if none was, in the usual one, where there need
/// not be one; either may be a case's folder. Throws InputError where the run that was asked for is
/// none, and where it is of another flag or stream than the case.
std::optional<RunOfCase> find_run(const Case&, const std::string& asked,
                                  const std::filesystem::path& usual);

}  // namespace pennon::app

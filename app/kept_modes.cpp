#include "app/kept_modes.hpp"

#include <fmt/format.h>

#include "app/result_folder.hpp"
#include "common/case/case_difference.hpp"
#include "common/errors.hpp"
#include "common/record/version.hpp"

namespace pennon::app {
namespace {

std::string heading_of_problem() {
  return fmt::format("# What pennon-global {} ({}) solved.\n", version(), commit());
}

bool changes_modes(const std::string& key) {
  return key != "modes.global.ranks" && key != "modes.global.frames" &&
         !key.starts_with("modes.global.neutral.") && !key.starts_with("modes.global.map.");
}

}  // namespace

std::string problem_text(const modes::global::Problem& problem) {
  return heading_of_problem() + resolved_text(problem.schema);
}

std::optional<modes::global::Findings> kept_global_modes(const modes::global::Problem& problem,
                                                         const std::filesystem::path& folder) {
  try {
    const std::filesystem::path file = folder / "global_problem.toml";
    const std::string there = text_of_file(file);
    if (!there.starts_with(heading_of_problem()) ||
        !case_differences(there, file.string(), resolved_text(problem.schema), changes_modes)
             .empty())
      return std::nullopt;
    modes::global::Findings found = modes::global::read_findings(folder / "global_modes.json");
    if (found.spectrum.modes.empty()) return std::nullopt;
    return found;
  } catch (const InputError&) {
  } catch (const FileError&) {
  }
  return std::nullopt;  // they are found anew
}

}  // namespace pennon::app

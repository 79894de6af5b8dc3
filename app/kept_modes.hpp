/// Global modes that an earlier command left for the same problem.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "modes/global/study/settings.hpp"
#include "modes/global/study/wire.hpp"

namespace pennon::app {

/// The text of global_problem.toml: the version of pennon, and every key with its value.
std::string problem_text(const modes::global::Problem&);

/// What global_modes.json in the folder holds, if this version of pennon wrote it for the same
/// problem. A neutral curve or a map, and the number of ranks, may differ: modes do not depend on
/// them. None where there is no such file, or it holds no mode or cannot be read.
std::optional<modes::global::Findings> kept_global_modes(const modes::global::Problem&,
                                                         const std::filesystem::path& folder);

}  // namespace pennon::app

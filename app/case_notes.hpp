/// What a user may not know of a case that is valid: settings without effect.
#pragma once

#include <string>
#include <vector>

#include "app/case.hpp"

namespace pennon::app {

/// Sentences on the settings that the command passes over, or that leave it nothing to do.
/// `command` is its name, "dns".
std::vector<std::string> notes_on(const Case&, const std::string& command);

}  // namespace pennon::app

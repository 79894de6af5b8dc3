/// How much memory this machine has free.
#pragma once

#include <optional>

namespace pennon {

/// In bytes, with what the system can take back from its caches; none where it does not say.
std::optional<double> available_memory();

}  // namespace pennon

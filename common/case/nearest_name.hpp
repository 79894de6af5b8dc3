/// The known name a misspelt one most likely means.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pennon {

/// The name among `known` nearest to `name` in edit distance (letter case and underscores count
/// half, a swap of neighbours one), or an empty string where none is near enough to be meant.
std::string nearest_name(std::string_view name, std::span<const std::string> known);

/// "; did you mean NAME?" or nothing.
std::string did_you_mean(std::string_view name, std::span<const std::string> known);

}  // namespace pennon

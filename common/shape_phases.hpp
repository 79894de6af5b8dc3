/// The phases at which files, tables and pictures show how the flag is bent in a mode:
/// Re [zeta exp(i phase)].
#pragma once

#include <array>

namespace pennon {

inline constexpr std::array shape_phases = {0, 45, 90, 135};  ///< degrees

}  // namespace pennon

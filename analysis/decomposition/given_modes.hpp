/// Modes that are known beforehand, on which the shapes of a flag are projected:
///
///     z(x, y, t) = Re sum_j a_j(t) Y_j(y) exp(i k_j x).
///
/// A normal mode has a real Y and a = A - i B in the words of modes/normal/decomposition.hpp. A
/// global mode with k_x > 0 has a counterpart with -k_x and the same Y, which travels the other
/// way.
#pragma once

#include <complex>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "modes/normal/normal_modes.hpp"

namespace pennon::decomposition {

struct GivenMode {
  std::string name;             ///< "n = 1, m = 2", "mode 1"
  double k = 0;                 ///< along x, of either sign
  std::complex<double> lambda;  ///< growth + i (angular frequency) as the mode has it
  std::function<std::complex<double>(double y)> Y;
  bool is_standing = false;  ///< real Y and k = 0: the imaginary part of a says nothing
};

std::vector<GivenMode> given_modes(const modes::NormalModes&);

/// The flag's part of the global modes in a file of `pennon modes`: the first `count`, or all that
/// do not belong to the box. Throws InputError where the file does not serve, or has fewer.
std::vector<GivenMode> given_global_modes(const std::filesystem::path&,
                                          std::optional<std::int64_t> count);

}  // namespace pennon::decomposition

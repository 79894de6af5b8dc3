#include "modes/normal/normal_modes.hpp"

#include <numbers>

namespace pennon::modes {

double spanwise_wavenumber(int n, const FlagParameters& flag) {
  return flag.gamma ? 2 * std::numbers::pi * n / *flag.gamma : 0;
}

}  // namespace pennon::modes

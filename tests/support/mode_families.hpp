/// A flag and all families of its normal modes.
#pragma once

#include <vector>

#include "modes/normal/bessel.hpp"
#include "modes/normal/hanging_chain.hpp"
#include "modes/normal/in_vacuo.hpp"

namespace pennon::test {

inline FlagParameters flag() {
  FlagParameters flag;
  flag.mu = 0.125;
  flag.K_B = 1e-4;
  flag.gamma = 2;
  return flag;
}
inline const FlowParameters flow{1000, 0};

/// `elements` along the chord for the modes in vacuum.
inline std::vector<modes::NormalModes> families(const modes::ModeRange& range, int elements) {
  return {modes::bessel_modes(range, flag(), flow), modes::hanging_chain_modes(range, flag(), flow),
          modes::in_vacuo_modes(range, flag(), flow, modes::TensionProfile::blasius, elements)};
}

}  // namespace pennon::test

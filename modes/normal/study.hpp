/// The normal modes that a case asks for, and the decomposition of a displacement into them.
#pragma once

#include <optional>
#include <vector>

#include "modes/normal/decomposition.hpp"
#include "modes/normal/settings.hpp"

namespace pennon::modes {

struct Result {
  NormalModes modes;
  std::vector<double> y;                    ///< equally spaced from 0 to 1
  std::vector<std::vector<double>> shapes;  ///< Y of each mode at these
  std::optional<Decomposition> decomposition;
};

/// Precondition: check() found no fault. Throws InputError for samples that do not do, SolverError
/// where the modes in vacuum do not converge.
Result run(const Settings&, const FlagParameters&, const FlowParameters&);

}  // namespace pennon::modes

/// The normal modes that a case asks for, and the decomposition of a displacement into them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <vector>

#include "common/io/output_folder.hpp"
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

/// Writes modes.csv, modes.h5 and, if there is one, decomposition.csv. Throws FileError.
void write(const Result&, const OutputFolder&);

/// The list of modes: family, n, m, k_x, alpha, omega, frequency.
nlohmann::ordered_json to_json(const Result&);

}  // namespace pennon::modes

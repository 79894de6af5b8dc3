/// What is reported of the global modes: for scripts, as tables and for the reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/io/output_folder.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// The value of "global" in summary.json: base_flow, requested, converged, how many were searched
/// next to a target, modes of the box found, left out as too fast and checked in a larger box,
/// modes with growth, omega, frequency, residual, kind and shares; with adjoints
/// biorthogonality_defect, adjoint_residual and sensitivity.
nlohmann::ordered_json to_json(const FoundModes&);

/// Writes global_modes.csv, the spectrum, and global_shapes.csv, the flag in each mode. Throws
/// FileError.
void write_tables(const FoundModes&, const OutputFolder&);

std::string text_of(const FoundModes&);

}  // namespace pennon::modes::global

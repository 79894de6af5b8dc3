/// What is reported of the normal modes: for scripts, as tables and shapes, and for the reader of
/// the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/io/output_folder.hpp"
#include "modes/normal/study.hpp"

namespace pennon::modes {

/// The list of modes: family, n, m, k_x, alpha, omega, frequency.
nlohmann::ordered_json to_json(const Result&);
/// truncation_error, amplitudes with n, m, A, B, and of a fit condition_number.
nlohmann::ordered_json to_json(const Decomposition&);

/// Writes modes.csv, modes.h5 and, if there is one, decomposition.csv. Throws FileError.
void write_tables(const Result&, const OutputFolder&);

/// The first modes, and how much of a displacement that was decomposed they leave out.
std::string text_of(const Result&);

}  // namespace pennon::modes

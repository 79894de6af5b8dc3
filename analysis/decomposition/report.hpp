/// What is reported of a decomposition: for scripts, as a table and for the reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/decomposition/study.hpp"

namespace pennon::decomposition {

/// The object of the key "decompose".
nlohmann::ordered_json to_json(const Decomposition&);

/// Without the notes.
std::string text_of(const Decomposition&);

/// Writes decomposition.csv: a row for each mode, or for spod for each frequency. Throws FileError.
void write_table(const Decomposition&, const OutputFolder&);

}  // namespace pennon::decomposition

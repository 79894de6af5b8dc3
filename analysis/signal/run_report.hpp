/// What is reported of a coupled run: for scripts, as tables and for the reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "analysis/signal/run_study.hpp"
#include "common/io/output_folder.hpp"

namespace pennon::analysis {

/// The object of the key "analyze".
nlohmann::ordered_json to_json(const RunAnalysis&);

/// Without the notes.
std::string text_of(const RunAnalysis&);

/// Writes spanwise_amplitudes.csv, limit_cycle.csv and energy.csv. Throws FileError.
void write_tables(const RunAnalysis&, const OutputFolder&);

}  // namespace pennon::analysis

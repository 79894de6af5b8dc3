/// What `pennon modes` writes of a neutral curve and of a map of growth rates: tables, pictures
/// with the local theory and known outcomes beside them, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/case.hpp"
#include "common/io/output_folder.hpp"

namespace pennon::app {

/// Writes global_neutral.csv (mu_cr), global_neutral_branches.csv (all modes that were followed)
/// and global_neutral.h5 with its picture: mu_cr, the local theory's for each added mass, and the
/// outcomes of lsa.marks. `global`: what pennon-global found. Throws FileError, InputError.
void write_neutral_curve(const nlohmann::ordered_json& global, const Case&, const OutputFolder&);

std::string text_of_neutral_curve(const nlohmann::ordered_json& global);

/// Writes global_map.csv, and global_map.h5 with its picture: growth rate and angular frequency,
/// the neutral curve and the outcomes of lsa.marks. `map`: what pennon-global found. Throws as
/// above.
void write_growth_map(const nlohmann::ordered_json& map, const Case&, const OutputFolder&);

/// Of a map for summary.json: its size, errors and times.
nlohmann::ordered_json summary_of_map(const nlohmann::ordered_json& map);
std::string text_of_growth_map(const nlohmann::ordered_json& map, double lambda_tolerance);

}  // namespace pennon::app

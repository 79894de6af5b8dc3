/// What `pennon modes` writes of a neutral curve: tables, a picture with the local theory beside
/// it, a few lines of text.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "app/case.hpp"
#include "common/output_folder.hpp"

namespace pennon::app {

/// Writes global_neutral.csv (mu_cr), global_neutral_branches.csv (all modes that were followed)
/// and global_neutral.h5 with its picture: mu_cr, the local theory's for each added mass, and the
/// outcomes of lsa.marks. `global`: what pennon-global found. Throws FileError, InputError.
void write_neutral_curve(const nlohmann::ordered_json& global, const Case&, const OutputFolder&);

std::string text_of_neutral_curve(const nlohmann::ordered_json& global);

}  // namespace pennon::app

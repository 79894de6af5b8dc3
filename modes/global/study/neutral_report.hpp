/// What is reported of a neutral curve: for scripts, as tables, as the data of a picture and for
/// the reader of the screen.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"
#include "common/io/outcome_points.hpp"
#include "common/io/output_folder.hpp"
#include "modes/global/study/neutral_curve.hpp"

namespace pennon::modes::global {

/// The values of "neutral", "neutral_over" and "neutral_missing" in summary.json.
nlohmann::ordered_json to_json(const NeutralCurve&);

/// Writes global_neutral.csv (mu_cr) and global_neutral_branches.csv (all modes that were
/// followed). Throws FileError.
void write_tables(const NeutralCurve&, const OutputFolder&);

std::string text_of(const NeutralCurve&);

/// The critical mass ratio of another theory along the same parameter.
struct OtherCurve {
  std::string name;
  std::vector<double> x, mu_cr;
};

/// What a picture of the curve shows beside it.
struct NeutralPicture {
  std::string title;
  hdf5::Attributes axis;  ///< of the parameter: name, meaning, label, scale
  std::vector<OtherCurve> local_theory = {};
  OutcomePoints outcomes = {};  ///< over the parameter and mu
};

/// Writes the data of the picture, kind = "global_neutral": /x, /mu_cr, /branches [branch][x] (NaN
/// where one was not found), /local/NAME/x and y, /marks. Precondition: the curve has a point.
/// Throws FileError.
void write_hdf5(const NeutralCurve&, const NeutralPicture&, const std::filesystem::path&);

}  // namespace pennon::modes::global

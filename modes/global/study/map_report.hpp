/// What is reported of a map of growth rates: for scripts, as a table, as the data of a picture and
/// for the reader of the screen.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/io/hdf5.hpp"
#include "common/io/outcome_points.hpp"
#include "common/io/output_folder.hpp"
#include "modes/global/study/growth_map.hpp"

namespace pennon::modes::global {

/// The value of "map" in summary.json: its size, errors and times.
nlohmann::ordered_json to_json(const GrowthMap&);

/// Writes global_map.csv. Throws FileError.
void write_tables(const GrowthMap&, const OutputFolder&);

/// `lambda_tolerance`: what the case asked for; the text says where the map's error is larger.
std::string text_of(const GrowthMap&, double lambda_tolerance);

/// What a picture of the map says of its axes and shows beside it.
struct MapPicture {
  std::string title;
  hdf5::Attributes x_axis, mu_axis;  ///< name, meaning, label, scale
  OutcomePoints outcomes = {};       ///< over the parameter and mu
};

/// Writes the data of the picture, kind = "global_map": /x, /y (mu), /fields/growth and omega
/// [mu][x], /neutral/x and y (NaN where there is none on the map), /marks. Throws FileError.
void write_hdf5(const GrowthMap&, const MapPicture&, const std::filesystem::path&);

}  // namespace pennon::modes::global

/// What is reported of models of the same flag, side by side: for scripts, as a table and for the
/// reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/io/output_folder.hpp"

namespace pennon::app {

/// What a model says of waves along the span.
struct ComparedModel {
  std::string model;                                  ///< local, global, dns
  std::optional<double> waves = {};                   ///< n of k_x = 2 pi n/gamma
  std::optional<double> growth = {}, frequency = {};  ///< in V/L
  std::optional<bool> is_unstable = {};
  double wall_seconds = 0;
  std::optional<bool> travels_with_U = {};  ///< along the span, where there is a cross-flow
};

/// The value of "compare" in summary.json: model, waves, growth, frequency, unstable,
/// travels_with_cross_flow, wall_s; null where a model does not say it.
nlohmann::ordered_json to_json(const std::vector<ComparedModel>&);

/// Writes compare.csv. Throws FileError.
void write_table(const std::vector<ComparedModel>&, const OutputFolder&);

std::string text_of(const std::vector<ComparedModel>&);

}  // namespace pennon::app

/// Fields over two parameters, streamed to HDF5 in blocks of rows, with the neutral curve.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "common/io/output_folder.hpp"
#include "lsa/axes.hpp"
#include "lsa/evaluate.hpp"
#include "lsa/neutral.hpp"
#include "lsa/outcomes.hpp"
#include "lsa/settings.hpp"

namespace pennon::lsa {

/// The axes of a map: abscissa and ordinate with their values.
struct MapAxes {
  Axis x_axis, y_axis;
  Scale x_scale, y_scale;
  std::vector<double> x, y;
};
/// If one of the axes is mu, it is the ordinate. Precondition: check() accepts the settings.
MapAxes axes_of(const MapSettings& settings);

struct MapSummary {
  std::int64_t points = 0;
  std::int64_t unstable = 0;
  double wall_seconds = 0;  ///< of evaluating and writing the fields
  std::vector<Polyline> neutral;
};

/// Computes the fields over the map and writes them to `folder`/map.h5 (kind = "lsa_map": /x, /y,
/// /fields/NAME [y][x], /neutral/x and /neutral/y with a NaN between polylines, /marks) and the
/// neutral curve to `folder`/neutral.csv. Threads share the rows; the results do not depend on
/// their number. It takes the memory of two axes and 64 MB. Throws FileError, SolverError and
/// Interrupted.
MapSummary compute_map(const MapSettings&, const Point&, const Theory&,
                       const std::vector<Outcome>& outcomes, const OutputFolder& folder,
                       bool shows_progress);

}  // namespace pennon::lsa

/// A quantity along one parameter, for each of a list of values of a second.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "common/io/hdf5.hpp"
#include "lsa/axes.hpp"
#include "lsa/evaluate.hpp"
#include "lsa/outcomes.hpp"
#include "lsa/settings.hpp"

namespace pennon::lsa {

struct Curve {
  Axis axis;
  Scale scale;
  std::vector<double> x;
  std::optional<Axis> family_axis;  ///< none: one curve
  std::vector<double> family;       ///< values of family_axis; one NaN where there is no family
  std::string quantity;
  std::string title;
  std::vector<std::vector<double>> values;  ///< [family][x]; NaN where there is no value
};

/// Precondition: check() accepts the settings. Throws what solve() throws.
Curve compute(const CurveSettings& settings, const Point& point, const Theory&);

/// Writes a column for the axis and one for each member of the family. Throws FileError.
void write_csv(const Curve&, const std::filesystem::path&);

/// Writes /x, /values [family][x] and, if there is a family, /family, with their names, meanings
/// and symbols. Throws FileError.
void write_lines(const Curve&, hdf5::Writer&);

/// Writes the lines and the outcomes (lsa/outcome_points.hpp) as a file of kind "lsa_curve", which
/// can be drawn. Throws FileError.
void write_hdf5(const Curve&, const std::vector<Outcome>& outcomes, bool cross_flow,
                const std::filesystem::path&);

}  // namespace pennon::lsa

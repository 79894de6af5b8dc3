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
  std::vector<double> family;       ///< its values; one NaN where there is no family
  std::string quantity;
  std::string title;
  std::vector<std::vector<double>> values;  ///< [family][x]; NaN where there is no value
};

/// `settings` as check() accepts them. Throws as solve().
Curve compute(const CurveSettings& settings, const Point& point, const Theory&);

/// curve.csv's columns: the axis, then a column for each member of the family. Throws FileError.
void write_csv(const Curve&, const std::filesystem::path&);

/// Writes /x, /values [family][x] and, if there is a family, /family, with their names, meanings
/// and symbols. Throws FileError.
void write_lines(const Curve&, hdf5::Writer&);

/// The same as HDF5, with what a picture needs: kind = "lsa_curve". `outcomes`: see
/// lsa/outcome_points.hpp. Throws FileError.
void write_hdf5(const Curve&, const std::vector<Outcome>& outcomes, bool cross_flow,
                const std::filesystem::path&);

}  // namespace pennon::lsa

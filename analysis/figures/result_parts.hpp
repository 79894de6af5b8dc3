/// What the pictures of several kinds of result files have in common.
#pragma once

#include <string>
#include <vector>

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// An axis over the values of an array, by the array's label and scale (symbol.hpp).
FigureAxis axis_of(const hdf5::Reader&, const std::string& array);

/// Ends the axis where these values end, unless there are fewer than two.
void fit(FigureAxis&, const std::vector<double>& increasing);

/// Whether a line of these values is worth drawing: one of them differs from zero.
bool has_nonzero(const std::vector<double>& values);

/// Of an array with two indices, or more of which the last counts for a row.
std::vector<double> row_of(const hdf5::Array&, std::size_t index);
std::vector<double> column_of(const hdf5::Array&, std::size_t index);

/// The corners /points and an array of the cells between them, as plane_section() takes them.
struct SectionArrays {
  hdf5::Array points, values;
};
/// Throws InputError where they do not fit together.
SectionArrays section_arrays(const hdf5::Reader&, const std::string& array);

/// The outcomes of a table at /marks: the stable ones as open squares, the unstable ones as filled
/// ones. Empty where the file has none.
std::vector<Marks> outcome_marks(const hdf5::Reader&);

}  // namespace pennon::analysis

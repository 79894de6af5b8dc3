#include "analysis/figures/result_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "analysis/figures/symbol.hpp"

namespace pennon::analysis {

FigureAxis axis_of(const hdf5::Reader& file, const std::string& array) {
  FigureAxis axis;
  axis.label = label_of(file, array);
  axis.is_log = file.text(array, "scale") == "log";
  return axis;
}

void fit(FigureAxis& axis, const std::vector<double>& increasing) {
  if (increasing.size() < 2) return;
  axis.low = increasing.front();
  axis.high = increasing.back();
}

bool has_nonzero(const std::vector<double>& values) {
  return std::ranges::any_of(values, [](double value) { return value != 0; });
}

std::vector<double> row_of(const hdf5::Array& array, std::size_t index) {
  const auto width = static_cast<std::ptrdiff_t>(array.shape.back());
  const auto begin = array.values.begin() + static_cast<std::ptrdiff_t>(index) * width;
  return {begin, begin + width};
}

std::vector<double> column_of(const hdf5::Array& array, std::size_t index) {
  const std::size_t width = array.shape.back();
  std::vector<double> values;
  for (std::size_t k = index; k < array.values.size(); k += width)
    values.push_back(array.values[k]);
  return values;
}

SectionArrays section_arrays(const hdf5::Reader& file, const std::string& array) {
  const hdf5::Shape cells = file.shape(array);
  const bool has_planes = cells.size() == 3;
  if (cells.size() != 2 && !has_planes)
    file.fail(
        fmt::format("has an array {} of {} indices, where rho and theta, or x, rho and theta "
                    "are needed",
                    array, cells.size()));
  hdf5::Shape corners;
  for (const hsize_t count : cells) {
    if (count == 0) file.fail(fmt::format("has no values in {}", array));
    corners.push_back(count + 1);
  }
  // Planes of earlier versions have no x.
  const hdf5::Shape points = file.shape("/points");
  corners.push_back(!has_planes && !points.empty() && points.back() == 2 ? 2 : 3);
  return {file.read("/points", corners), file.read(array)};
}

std::vector<Marks> outcome_marks(const hdf5::Reader& file) {
  if (!file.contains("/marks/x")) return {};
  const std::vector<double> x = file.list("/marks/x", hdf5::any_or_none),
                            y = file.list("/marks/y", x.size()),
                            unstable = file.list("/marks/unstable", x.size());
  Marks stable_marks{{}, {}, "stable in the table", Marker::square, false, 0};
  Marks unstable_marks{{}, {}, "unstable in the table", Marker::square, true, 0};
  for (std::size_t i = 0; i < x.size(); ++i) {
    Marks& marks = unstable[i] > 0 ? unstable_marks : stable_marks;
    marks.x.push_back(x[i]);
    marks.y.push_back(y[i]);
  }
  std::vector<Marks> drawn;
  for (Marks* marks : {&stable_marks, &unstable_marks})
    if (!marks->x.empty()) drawn.push_back(std::move(*marks));
  return drawn;
}

}  // namespace pennon::analysis

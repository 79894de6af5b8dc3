#include "analysis/figures/result_parts.hpp"

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

std::vector<Marks> outcome_marks(const hdf5::Reader& file) {
  if (!file.contains("/marks/x")) return {};
  const hdf5::Array x = file.read("/marks/x");
  const hdf5::Array y = file.read("/marks/y");
  const hdf5::Array unstable = file.read("/marks/unstable");
  Marks stable_marks{{}, {}, "stable in the table", Marker::square, false, 0};
  Marks unstable_marks{{}, {}, "unstable in the table", Marker::square, true, 0};
  for (std::size_t i = 0; i < x.values.size(); ++i) {
    Marks& marks = unstable.values[i] > 0 ? unstable_marks : stable_marks;
    marks.x.push_back(x.values[i]);
    marks.y.push_back(y.values[i]);
  }
  std::vector<Marks> drawn;
  for (Marks* marks : {&stable_marks, &unstable_marks})
    if (!marks->x.empty()) drawn.push_back(std::move(*marks));
  return drawn;
}

}  // namespace pennon::analysis

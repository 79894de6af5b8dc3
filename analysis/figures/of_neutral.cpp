#include "analysis/figures/of_neutral.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "analysis/figures/result_parts.hpp"
#include "analysis/figures/symbol.hpp"

namespace pennon::analysis {
namespace {

struct LocalTheory {
  const char* array;
  const char* label;
};
constexpr std::array local_theories = {
    LocalTheory{"two_d", "local theory, {/:Italic c_m} in 2D"},
    LocalTheory{"wu", "local theory, {/:Italic c_m} of Wu"},
    LocalTheory{"lamb", "local theory, {/:Italic c_m} of Lamb"},
    LocalTheory{"minami", "local theory, {/:Italic c_m} of Minami"}};

// Of what is drawn, a little above the highest point.
constexpr double headroom = 1.15;

double highest(const std::vector<double>& values, double so_far) {
  for (const double value : values)
    if (std::isfinite(value)) so_far = std::max(so_far, value);
  return so_far;
}

void add_local_theories(const hdf5::Reader& file, Figure& figure) {
  int color = 1;
  for (const auto& [array, label] : local_theories) {
    const std::string group = std::string("/local/") + array;
    if (file.contains(group + "/x")) {
      const std::vector<double> x = file.list(group + "/x"), y = file.list(group + "/y", x.size());
      figure.lines.push_back({x, y, label, Stroke::dashed, color});
    }
    ++color;
  }
}

}  // namespace

Figure figure_of_neutral_curve(const hdf5::Reader& file) {
  Figure figure;
  figure.title = file.text("/", "title");
  figure.x = axis_of(file, "/x");
  figure.y.label = label_of(file, "/mu_cr");
  const std::vector<double> x = file.list("/x"), mu = file.list("/mu_cr", x.size());
  fit(figure.x, x);
  figure.lines.push_back({x, mu, "global modes", Stroke::solid, 0, 2.5});
  add_local_theories(file, figure);
  figure.marks = outcome_marks(file);
  double top = 0;
  for (const Line& line : figure.lines) top = highest(line.y, top);
  for (const Marks& marks : figure.marks) top = highest(marks.y, top);
  figure.y.low = 0;
  figure.y.high = headroom * top;
  const hdf5::Array branches = file.read("/branches", {hdf5::any_or_none, x.size()});
  for (std::size_t b = 0; b < branches.shape[0]; ++b) {
    const auto begin = branches.values.begin() + static_cast<std::ptrdiff_t>(b * x.size());
    figure.lines.push_back({x,
                            {begin, begin + static_cast<std::ptrdiff_t>(x.size())},
                            b == 0 ? "neutral modes that were followed" : "",
                            Stroke::dotted,
                            0,
                            1.0});
  }
  figure.marks.push_back({x, mu, "", Marker::circle, true, 0});
  return figure;
}

}  // namespace pennon::analysis

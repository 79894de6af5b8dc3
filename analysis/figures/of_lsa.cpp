#include "analysis/figures/of_lsa.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/figures/result_parts.hpp"
#include "analysis/figures/symbol.hpp"

namespace pennon::analysis {
namespace {

constexpr std::size_t most_nodes_drawn = 1000;  // along an axis; a picture shows no more
constexpr double none = std::numeric_limits<double>::quiet_NaN();

Stroke stroke(std::size_t index) {
  return static_cast<Stroke>(index % 4);
}

// "k_x L = 0.5"; no spanwise variation is called by its name.
std::string member_label(const hdf5::Reader& file, double member) {
  if (file.text("/family", "name") == "k_x" && member == 0) return "2D";
  return fmt::format("{} = {:.4g}", label_of(file, "/family"), member);
}

std::size_t thinning(std::size_t nodes) {
  return (nodes + most_nodes_drawn - 1) / most_nodes_drawn;
}

// Blanks what does not grow, but for the nodes next to those that do, so that the colours reach the
// neutral curve.
void leave_stable_side_white(FigureField& field) {
  const std::size_t width = field.x.size();
  const std::size_t height = field.y.size();
  const std::vector<double> growth = field.values;
  const auto grows_near = [&](std::size_t i, std::size_t j) {
    for (std::size_t b = j - std::min<std::size_t>(j, 1); b <= std::min(j + 1, height - 1); ++b)
      for (std::size_t a = i - std::min<std::size_t>(i, 1); a <= std::min(i + 1, width - 1); ++a)
        if (growth[b * width + a] > 0) return true;
    return false;
  };
  for (std::size_t j = 0; j < height; ++j)
    for (std::size_t i = 0; i < width; ++i)
      if (!grows_near(i, j)) field.values[j * width + i] = none;
}

FigureField field_of(const hdf5::Reader& file) {
  const std::string name = file.text("/", "picture");
  const std::string array = "/fields/" + name;
  const hdf5::Shape x = file.shape("/x", {hdf5::any}), y = file.shape("/y", {hdf5::any});
  const hdf5::Shape shape = file.shape(array, {y[0], x[0]});
  const hdf5::Shape strides = {thinning(shape[0]), thinning(shape[1])};
  FigureField field{file.read_every("/x", {strides[1]}).values,
                    file.read_every("/y", {strides[0]}).values,
                    file.read_every(array, strides).values, label_of(file, array),
                    file.number(array, "is_signed", 0) != 0};
  if (name == "growth") leave_stable_side_white(field);
  return field;
}

}  // namespace

Figure figure_of_curve(const hdf5::Reader& file) {
  Figure figure;
  figure.title = file.text("/", "title");
  figure.x = axis_of(file, "/x");
  figure.y = axis_of(file, "/values");
  const std::vector<double> x = file.list("/x");
  fit(figure.x, x);
  const bool is_family = file.contains("/family");
  const std::vector<double> family = is_family ? file.list("/family") : std::vector<double>{none};
  const hdf5::Array values = file.read("/values", {family.size(), x.size()});
  for (std::size_t i = 0; i < family.size(); ++i)
    figure.lines.push_back({x, row_of(values, i), is_family ? member_label(file, family[i]) : "",
                            stroke(i), static_cast<int>(i)});
  figure.marks = outcome_marks(file);
  return figure;
}

Figure figure_of_map(const hdf5::Reader& file) {
  Figure figure;
  figure.title = file.text("/", "title");
  figure.x = axis_of(file, "/x");
  figure.y = axis_of(file, "/y");
  figure.field = field_of(file);
  if (file.contains("/neutral/x")) {
    const std::vector<double> x = file.list("/neutral/x", hdf5::any_or_none),
                              y = file.list("/neutral/y", x.size());
    figure.lines.push_back({x, y,
                            file.text("/neutral/x", "label", "neutral curve {/:Italic P} = 0"),
                            Stroke::solid, 0, 2.0});
  }
  figure.marks = outcome_marks(file);
  return figure;
}

Figure figure_of_verdicts(const hdf5::Reader& file) {
  Figure figure;
  figure.title = file.text("/", "title");
  figure.x = axis_of(file, "/x");
  figure.y = axis_of(file, "/values");
  figure.y.low = 0;
  const std::vector<double> x = file.list("/x");
  fit(figure.x, x);
  const std::vector<double> spans = file.list("/family");
  const hdf5::Array values = file.read("/values", {spans.size(), x.size()});
  for (std::size_t i = 0; i < spans.size(); ++i) {
    const std::string label =
        spans[i] == 0 ? "2D"
                      : fmt::format("{{/:Italic γ}} = {:.3g}", 2 * std::numbers::pi / spans[i]);
    figure.lines.push_back({x, row_of(values, i), label, stroke(i), static_cast<int>(i + 1)});
  }
  const std::vector<double> mass_ratios = file.list("/mu");
  figure.y.high = 1.3 * *std::ranges::max_element(mass_ratios);
  for (std::size_t i = 0; i < mass_ratios.size(); ++i)
    figure.lines.push_back({{x.front(), x.back()},
                            {mass_ratios[i], mass_ratios[i]},
                            i == 0 ? "{/:Italic μ} of the table" : "",
                            Stroke::dotted,
                            0,
                            1.0});
  if (file.contains("/reproduced")) {
    const std::vector<double> ends = file.read("/reproduced", {hdf5::any_or_none, 2}).values;
    for (std::size_t i = 0; i < ends.size(); ++i)
      figure.lines.push_back({{ends[i], ends[i]},
                              {0, *figure.y.high},
                              i == 0 ? "all reproduced between" : "",
                              Stroke::dashed,
                              0,
                              1.0});
  }
  return figure;
}

}  // namespace pennon::analysis

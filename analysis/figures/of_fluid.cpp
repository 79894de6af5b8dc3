#include "analysis/figures/of_fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <string>

#include "analysis/drawing/plane_section.hpp"
#include "analysis/figures/result_parts.hpp"

namespace pennon::analysis {
namespace {

// The column of a history that has a name.
std::vector<double> column(const hdf5::Reader& file, const hdf5::Array& history,
                           const std::string& name) {
  std::istringstream names(file.text("/history", "columns"));
  std::size_t index = 0;
  std::string found;
  while (std::getline(names, found, ',') && found != name) ++index;
  if (found != name || index >= history.shape[1])
    file.fail(fmt::format("has no column {} in /history", name));
  std::vector<double> values;
  for (std::size_t row = 0; row < history.shape[0]; ++row)
    values.push_back(history.values[row * history.shape[1] + index]);
  return values;
}

}  // namespace

Figure figure_of_fluid_history(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "{/:Italic tV}/{/:Italic L}";
  figure.y.label = "force coefficient";
  const hdf5::Array history = file.read("/history", {hdf5::any_or_none, hdf5::any});
  const std::vector<double> t = column(file, history, "t");
  figure.lines.push_back({t, column(file, history, "C_D"), "{/:Italic C_D}", Stroke::solid, 1});
  figure.lines.push_back({t, column(file, history, "C_L"), "{/:Italic C_L}", Stroke::dashed, 2});
  std::vector<double> side = column(file, history, "C_S");
  if (std::ranges::any_of(side, [](double force) { return force != 0; }))
    figure.lines.push_back({t, std::move(side), "{/:Italic C_S}", Stroke::dotted, 3});
  return figure;
}

Figure figure_of_trailing_edge(const hdf5::Reader& file) {
  constexpr std::size_t components = 3, z_component = 2, stations_drawn = 4;
  Figure figure;
  figure.x.label = "{/:Italic tV}/{/:Italic L}";
  figure.y.label = "{/:Italic z}/{/:Italic L} of the trailing edge";
  const std::vector<double> t =
      column(file, file.read("/history", {hdf5::any_or_none, hdf5::any}), "t");
  const hdf5::Array edge = file.read("/trailing_edge", {t.size(), hdf5::any, components});
  const std::size_t planes = edge.shape[1], drawn = std::min(planes, stations_drawn);
  for (std::size_t k = 0; k < drawn; ++k) {
    const std::size_t m = k * planes / drawn;
    Line line{t, {}, "", Stroke::solid, static_cast<int>(k), 1.2};
    for (std::size_t row = 0; row < t.size(); ++row)
      line.y.push_back(edge.values[(row * planes + m) * components + z_component]);
    if (drawn > 1)
      line.label = fmt::format(
          "{{/:Italic x}} = {:.3g} {{/:Italic L}}",
          file.number("/", "span", 1) * static_cast<double>(m) / static_cast<double>(planes));
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

Figure figure_of_fluid_fields(const hdf5::Reader& file) {
  constexpr PlaneWindow flag_and_wake{-0.5, 4.5, -1.25, 1.25};
  const auto [points, omega] = section_arrays(file, "/omega_x");
  FigureField field = plane_section(points, omega, flag_and_wake);
  field.label = "{/:Italic ω_x L}/{/:Italic V}";
  field.is_diverging = true;
  clip_to_most(field);
  Figure figure = figure_of_section(std::move(field), points, omega.shape.back(), flag_and_wake);
  figure.title = fmt::format("tV/L = {:.4g}", file.number("/", "t", 0));
  return figure;
}

}  // namespace pennon::analysis

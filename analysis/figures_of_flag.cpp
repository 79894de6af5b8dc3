#include "analysis/figures_of_flag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace pennon::analysis {
namespace {

// Columns of the history, by their order in dns/flag_history.cpp.
enum Column : std::size_t {
  t = 0,
  kinetic = 4,
  bending,
  stretch_2d,
  stretch_3d,
  gravity,
  dissipated,
  work,
  total
};

constexpr std::size_t most_shapes_drawn = 40;

std::vector<double> column(const hdf5::Array& history, std::size_t index) {
  std::vector<double> values;
  for (std::size_t row = 0; row < history.shape[0]; ++row)
    values.push_back(history.values[row * history.shape[1] + index]);
  return values;
}

bool is_drawn(const std::vector<double>& energy) {
  return std::ranges::any_of(energy, [](double e) { return e != 0; });
}

}  // namespace

Figure figure_of_flag_history(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "{/:Italic tV}/{/:Italic L}";
  figure.y.label = "energy";
  const hdf5::Array history = file.read("/history");
  const std::vector<double> times = column(history, t);
  struct Drawn {
    Column column;
    const char* label;
    Stroke stroke;
  };
  constexpr Drawn drawn[] = {{kinetic, "kinetic", Stroke::solid},
                             {bending, "bending", Stroke::solid},
                             {stretch_2d, "stretch of the chord", Stroke::solid},
                             {stretch_3d, "stretch of the span", Stroke::dashed},
                             {gravity, "gravitational", Stroke::solid},
                             {dissipated, "dissipated", Stroke::dotted},
                             {work, "work of the loads", Stroke::dash_dotted},
                             {total, "total", Stroke::solid}};
  int color = 1;
  for (const Drawn& one : drawn) {
    std::vector<double> energy = column(history, one.column);
    if (one.column != total && !is_drawn(energy)) continue;
    const bool is_total = one.column == total;
    figure.lines.push_back({times, std::move(energy), one.label, one.stroke, is_total ? 0 : color++,
                            is_total ? 2.0 : 1.5});
  }
  return figure;
}

Figure figure_of_flag_convergence(const hdf5::Reader& file) {
  Figure figure;
  if (file.text("/", "of") == "frequency") {
    figure.x = {"{/:Italic Δt V}/{/:Italic L}", true, {}, {}};
    figure.y = {"error of the frequency {/:Italic ωL}/{/:Italic V}", true, {}, {}};
  } else {
    figure.x = {"1/({/:Italic N} − 1)", true, {}, {}};
    figure.y = {"error of the deflection / {/:Italic L}", true, {}, {}};
  }
  const std::vector<double> h = file.read("/h").values;
  const std::vector<double> error = file.read("/error").values;
  const double order = file.number("/", "order", 0);
  figure.marks.push_back({h, error, "flag", Marker::circle, true, 1});
  // The fitted power through the geometric middle of the points.
  double log_h = 0;
  double log_error = 0;
  for (std::size_t k = 0; k < h.size(); ++k) {
    log_h += std::log(h[k]) / static_cast<double>(h.size());
    log_error += std::log(error[k]) / static_cast<double>(h.size());
  }
  Line fit{h, {}, fmt::format("power {:.2f}", order), Stroke::dashed, 0, 1.5};
  for (const double spacing : h)
    fit.y.push_back(std::exp(log_error + order * (std::log(spacing) - log_h)));
  figure.lines.push_back(std::move(fit));
  return figure;
}

Figure figure_of_flag_shapes(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "{/:Italic y}/{/:Italic L}";
  figure.y.label = "{/:Italic z}/{/:Italic L}";
  const std::vector<double> times = file.read("/shape_times").values;
  const hdf5::Array shapes = file.read("/shapes");
  const std::size_t nodes = shapes.shape[1];
  const auto chord_nodes = static_cast<std::size_t>(file.number("/", "chord_nodes", 0));
  const std::size_t stride = (times.size() + most_shapes_drawn - 1) / most_shapes_drawn;
  for (std::size_t s = 0; s < times.size(); s += std::max<std::size_t>(stride, 1)) {
    Line line;
    for (std::size_t j = 0; j < chord_nodes; ++j) {
      line.x.push_back(shapes.values[(s * nodes + j) * 3 + 1]);
      line.y.push_back(shapes.values[(s * nodes + j) * 3 + 2]);
    }
    line.width = 1;
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

}  // namespace pennon::analysis

#include "analysis/figures/of_flag.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/result_parts.hpp"

namespace pennon::analysis {
namespace {

// Columns of the history, by their order in dns/run/flag_history.cpp.
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

constexpr std::size_t columns_of_history = 15;
constexpr std::size_t most_shapes_drawn = 40;
constexpr std::size_t surfaces_unasked = 6;
constexpr hsize_t components = 3;  // of a position

// The shapes whose strain is drawn: the nearest to the times asked for, or a few at equal
// intervals.
std::vector<std::size_t> shapes_with_strain(const hdf5::Reader& file) {
  const std::vector<double> times = file.list("/shape_times");
  std::vector<std::size_t> chosen;
  for (const double asked : file.list("/contour_times", hdf5::any_or_none)) {
    const auto distance = [&](double t) { return std::abs(t - asked); };
    chosen.push_back(
        static_cast<std::size_t>(std::ranges::min_element(times, {}, distance) - times.begin()));
  }
  if (!chosen.empty()) return chosen;
  const std::size_t count = std::min(surfaces_unasked, times.size());
  for (std::size_t k = 0; k < count; ++k)
    chosen.push_back(count == 1 ? 0 : k * (times.size() - 1) / (count - 1));
  return chosen;
}

std::string array_name(const char* quantity, std::size_t shape) {
  return fmt::format("/{}/{:06}", quantity, shape);
}

// Values of the cells of a grid at its nodes: means of the cells around.
std::vector<double> at_nodes(const std::vector<double>& of_cells, std::size_t rows,
                             std::size_t columns) {
  std::vector<double> sums(rows * columns, 0.0), shares(rows * columns, 0.0);
  for (std::size_t i = 0; i + 1 < rows; ++i)
    for (std::size_t j = 0; j + 1 < columns; ++j)
      for (const std::size_t node : {i * columns + j, i * columns + j + 1, (i + 1) * columns + j,
                                     (i + 1) * columns + j + 1}) {
        sums[node] += of_cells[i * (columns - 1) + j];
        shares[node] += 1;
      }
  for (std::size_t node = 0; node < sums.size(); ++node) sums[node] /= shares[node];
  return sums;
}

}  // namespace

Figure figure_of_flag_history(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "{/:Italic tV}/{/:Italic L}";
  figure.y.label = "energy";
  const hdf5::Array history = file.read("/history", {hdf5::any_or_none, columns_of_history});
  const std::vector<double> times = column_of(history, t);
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
    std::vector<double> energy = column_of(history, one.column);
    if (one.column != total && !has_nonzero(energy)) continue;
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
  const std::vector<double> h = file.list("/h"), error = file.list("/error", h.size());
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
  const std::vector<double> times = file.list("/shape_times");
  const std::size_t stride = (times.size() + most_shapes_drawn - 1) / most_shapes_drawn;
  for (std::size_t s = 0; s < times.size(); s += std::max<std::size_t>(stride, 1)) {
    const hdf5::Array nodes =
        file.read(array_name("position", s), {hdf5::any, hdf5::any, components});
    Line line;
    for (std::size_t j = 0; j < nodes.shape[1]; ++j) {
      line.x.push_back(nodes.values[3 * j + 1]);
      line.y.push_back(nodes.values[3 * j + 2]);
    }
    line.width = 1;
    figure.lines.push_back(std::move(line));
  }
  return figure;
}

SurfacePicture picture_of_strain(const hdf5::Reader& file) {
  SurfacePicture picture{"{/:Italic x}/{/:Italic L}",
                         "{/:Italic y}/{/:Italic L}",
                         "{/:Italic z}/{/:Italic L}",
                         "strain along the chord",
                         {}};
  for (const std::size_t s : shapes_with_strain(file)) {
    const hdf5::Array nodes =
        file.read(array_name("position", s), {hdf5::any, hdf5::any, components});
    const hdf5::Shape cells = {nodes.shape[0] - 1, nodes.shape[1] - 1};
    if (cells[0] == 0 || cells[1] == 0)
      file.fail(fmt::format("has no cells in {}", array_name("position", s)));
    Surface surface{nodes.shape[0], nodes.shape[1], {}, {}, {}, {}};
    for (std::size_t n = 0; n < nodes.values.size(); n += 3) {
      surface.x.push_back(nodes.values[n]);
      surface.y.push_back(nodes.values[n + 1]);
      surface.z.push_back(nodes.values[n + 2]);
    }
    surface.values =
        at_nodes(file.read(array_name("e_1", s), cells).values, surface.rows, surface.columns);
    picture.surfaces.push_back(std::move(surface));
  }
  return picture;
}

}  // namespace pennon::analysis

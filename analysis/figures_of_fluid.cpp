#include "analysis/figures_of_fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace pennon::analysis {
namespace {

// The column of a history that has a name.
std::vector<double> column(const hdf5::Reader& file, const hdf5::Array& history,
                           const std::string& name) {
  const std::string names = file.text("/history", "columns") + ",";
  std::size_t index = 0, at = 0;
  while (names.substr(at, names.find(',', at) - at) != name) {
    at = names.find(',', at) + 1;
    ++index;
  }
  std::vector<double> values;
  for (std::size_t row = 0; row < history.shape[0]; ++row)
    values.push_back(history.values[row * history.shape[1] + index]);
  return values;
}

// What of the section is shown, and on how many nodes.
constexpr double y_low = -0.5, y_high = 4.5, z_low = -1.25, z_high = 1.25;
constexpr std::size_t columns = 800, rows = 400;

std::vector<double> equally_spaced(double low, double high, std::size_t count) {
  std::vector<double> values;
  for (std::size_t k = 0; k < count; ++k)
    values.push_back(low + (high - low) * static_cast<double>(k) / static_cast<double>(count - 1));
  return values;
}

struct Vertex {
  double y, z, value;
};

// Paints the nodes of the raster inside a triangle, linearly between its corners.
void paint(const std::array<Vertex, 3>& corners, Field& field) {
  const auto [a, b, c] = corners;
  const double area = (b.y - a.y) * (c.z - a.z) - (b.z - a.z) * (c.y - a.y);
  if (area == 0) return;
  const auto [left, right] = std::minmax({a.y, b.y, c.y});
  const auto [low, high] = std::minmax({a.z, b.z, c.z});
  const auto first = [](const std::vector<double>& nodes, double value) {
    return static_cast<std::size_t>(std::ranges::lower_bound(nodes, value) - nodes.begin());
  };
  for (std::size_t j = first(field.y, low); j < field.y.size() && field.y[j] <= high; ++j)
    for (std::size_t i = first(field.x, left); i < field.x.size() && field.x[i] <= right; ++i) {
      const double y = field.x[i] - a.y, z = field.y[j] - a.z;
      const double s = (y * (c.z - a.z) - z * (c.y - a.y)) / area;
      const double t = ((b.y - a.y) * z - (b.z - a.z) * y) / area;
      if (s < 0 || t < 0 || s + t > 1) continue;
      field.values[j * field.x.size() + i] =
          a.value + s * (b.value - a.value) + t * (c.value - a.value);
    }
}

// The shear at the wall is far above what is in the wake: colours end where all but these are.
void clip_to_most(Field& field) {
  constexpr double share = 0.98;
  std::vector<double> sizes;
  for (const double value : field.values)
    if (std::isfinite(value)) sizes.push_back(std::abs(value));
  if (sizes.empty()) return;
  const auto nth = static_cast<std::ptrdiff_t>(share * static_cast<double>(sizes.size() - 1));
  std::ranges::nth_element(sizes, sizes.begin() + nth);
  const double limit = sizes[static_cast<std::size_t>(nth)];
  for (double& value : field.values)
    if (std::isfinite(value)) value = std::clamp(value, -limit, limit);
}

}  // namespace

Figure figure_of_fluid_history(const hdf5::Reader& file) {
  Figure figure;
  figure.x.label = "{/:Italic tV}/{/:Italic L}";
  figure.y.label = "force coefficient";
  const hdf5::Array history = file.read("/history");
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
  const std::vector<double> t = column(file, file.read("/history"), "t");
  const hdf5::Array edge = file.read("/trailing_edge");
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
  const hdf5::Array points = file.read("/points"), omega = file.read("/omega_x");
  const std::size_t n_rho = *(omega.shape.end() - 2), n_theta = omega.shape.back();
  const std::size_t components = points.shape.back();  // y, z, and x before them where there is one
  const auto y = [&](std::size_t corner) { return points.values[(corner + 1) * components - 2]; };
  const auto z = [&](std::size_t corner) { return points.values[(corner + 1) * components - 1]; };
  // The value at a corner is the mean of the cells about it.
  const auto vertex = [&](std::size_t j, std::size_t i) {
    double sum = 0, count = 0;
    for (const std::size_t row : {j, j - 1}) {
      if (row >= n_rho) continue;  // also before the first
      for (const std::size_t cell : {i % n_theta, (i + n_theta - 1) % n_theta}) {
        sum += omega.values[row * n_theta + cell];
        count += 1;
      }
    }
    const std::size_t corner = j * (n_theta + 1) + i;
    return Vertex{y(corner), z(corner), sum / count};
  };
  Figure figure;
  figure.x = {"{/:Italic y}/{/:Italic L}", false, y_low, y_high};
  figure.y = {"{/:Italic z}/{/:Italic L}", false, z_low, z_high};
  Field field{equally_spaced(y_low, y_high, columns),
              equally_spaced(z_low, z_high, rows),
              {},
              "{/:Italic ω_x L}/{/:Italic V}",
              true};
  field.values.assign(columns * rows, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t j = 0; j < n_rho; ++j)
    for (std::size_t i = 0; i < n_theta; ++i) {
      const Vertex a = vertex(j, i), b = vertex(j + 1, i), c = vertex(j + 1, i + 1),
                   d = vertex(j, i + 1);
      paint({a, b, c}, field);
      paint({a, c, d}, field);
    }
  clip_to_most(field);
  figure.field = std::move(field);
  Line flag;
  for (std::size_t i = 0; i <= n_theta / 2; ++i) {
    flag.x.push_back(y(i));
    flag.y.push_back(z(i));
  }
  flag.width = 2.5;
  figure.lines.push_back(std::move(flag));
  figure.title = fmt::format("tV/L = {:.4g}", file.number("/", "t", 0));
  return figure;
}

}  // namespace pennon::analysis

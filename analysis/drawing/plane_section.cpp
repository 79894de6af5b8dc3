#include "analysis/drawing/plane_section.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace pennon::analysis {
namespace {

constexpr std::size_t columns = 800, rows = 400;  // of a window

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
void paint(const std::array<Vertex, 3>& corners, FigureField& field) {
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

// (y, z) of the corners.
class Corners {
 public:
  explicit Corners(const hdf5::Array& points) : points_(points), components_(points.shape.back()) {}
  double y(std::size_t corner) const { return points_.values[(corner + 1) * components_ - 2]; }
  double z(std::size_t corner) const { return points_.values[(corner + 1) * components_ - 1]; }

 private:
  const hdf5::Array& points_;
  std::size_t components_;
};

}  // namespace

FigureField plane_section(const hdf5::Array& points, const hdf5::Array& values,
                          const PlaneWindow& window) {
  const std::size_t n_rho = *(values.shape.end() - 2), n_theta = values.shape.back();
  const Corners corners(points);
  // The value at a corner is the mean of the cells about it.
  const auto vertex = [&](std::size_t j, std::size_t i) {
    double sum = 0, count = 0;
    for (const std::size_t row : {j, j - 1}) {
      if (row >= n_rho) continue;  // also before the first
      for (const std::size_t cell : {i % n_theta, (i + n_theta - 1) % n_theta}) {
        sum += values.values[row * n_theta + cell];
        count += 1;
      }
    }
    const std::size_t corner = j * (n_theta + 1) + i;
    return Vertex{corners.y(corner), corners.z(corner), sum / count};
  };
  FigureField field{equally_spaced(window.y_low, window.y_high, columns),
                    equally_spaced(window.z_low, window.z_high, rows),
                    {},
                    {}};
  field.values.assign(columns * rows, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t j = 0; j < n_rho; ++j)
    for (std::size_t i = 0; i < n_theta; ++i) {
      const Vertex a = vertex(j, i), b = vertex(j + 1, i), c = vertex(j + 1, i + 1),
                   d = vertex(j, i + 1);
      paint({a, b, c}, field);
      paint({a, c, d}, field);
    }
  return field;
}

void clip_to_most(FigureField& field, double share) {
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

Figure figure_of_section(FigureField field, const hdf5::Array& points, std::size_t n_theta,
                         const PlaneWindow& window) {
  Figure figure;
  figure.x = {"{/:Italic y}/{/:Italic L}", false, window.y_low, window.y_high};
  figure.y = {"{/:Italic z}/{/:Italic L}", false, window.z_low, window.z_high};
  figure.field = std::move(field);
  const Corners corners(points);
  Line flag;
  flag.x.reserve(n_theta / 2 + 1);
  flag.y.reserve(n_theta / 2 + 1);
  for (std::size_t i = 0; i <= n_theta / 2; ++i) {
    flag.x.push_back(corners.y(i));
    flag.y.push_back(corners.z(i));
  }
  flag.width = 2.5;
  figure.lines.push_back(std::move(flag));
  return figure;
}

}  // namespace pennon::analysis

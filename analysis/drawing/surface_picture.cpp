#include "analysis/drawing/surface_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/picture_style.hpp"
#include "common/errors.hpp"

namespace pennon::analysis {
namespace {

constexpr int bands = 12;  // of colour

void add_surface(const Surface& s, PlotItems& items) {
  std::vector<double> numbers;
  for (std::size_t n = 0; n < s.rows * s.columns; ++n)
    numbers.insert(numbers.end(), {s.x[n], s.y[n], s.z[n], s.values[n]});
  items.add(fmt::format("record=({},{}) format='%double%double%double%double' "
                        "using 1:2:3:4 with pm3d notitle",
                        s.columns, s.rows),
            numbers);
}

void add_outline(const Surface& s, PlotItems& items) {
  std::vector<std::size_t> nodes;
  for (std::size_t j = 0; j < s.columns; ++j) nodes.push_back(j);
  for (std::size_t i = 1; i < s.rows; ++i) nodes.push_back((i + 1) * s.columns - 1);
  for (std::size_t j = s.columns - 1; j-- > 0;) nodes.push_back((s.rows - 1) * s.columns + j);
  for (std::size_t i = s.rows - 1; i-- > 0;) nodes.push_back(i * s.columns);
  std::vector<double> numbers;
  for (const std::size_t n : nodes) numbers.insert(numbers.end(), {s.x[n], s.y[n], s.z[n]});
  items.add(fmt::format("record=({}) format='%double%double%double' using 1:2:3 "
                        "with lines lc rgb '#000000' lw 0.5 notitle",
                        nodes.size()),
            numbers);
}

// Throws InputError with the name of the picture.
void check(const SurfacePicture& picture, const std::string& name) {
  for (const Surface& s : picture.surfaces)
    for (const auto* numbers : {&s.x, &s.y, &s.z, &s.values})
      if (s.rows == 0 || s.columns == 0 || numbers->size() != s.rows * s.columns)
        throw InputError(name, fmt::format("a surface of {} x {} nodes has {} numbers for them",
                                           s.rows, s.columns, numbers->size()));
}

// The ends of the colours; a single value gets a band around it.
std::pair<double, double> range_of(const SurfacePicture& picture) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Surface& surface : picture.surfaces)
    for (const double value : surface.values) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
  if (low > high) return {0, 1};
  const double margin = low < high ? 0 : std::max(0.1 * std::abs(low), 1e-3);
  return {low - margin, high + margin};
}

// The camera looks along the span from above, the chord to the right.
constexpr const char* stage =
    "set encoding utf8\nset minussign\nset view 78,68,1.25\nset view equal xyz\n"
    "set lmargin at screen 0.13\nset rmargin at screen 0.81\n"
    "set colorbox user origin 0.85,0.25 size 0.02,0.5\n"
    "set xyplane relative 0\nset border 4095 lw 0.3 lc rgb '#999999'\n"
    "set tics out scale 0.5 textcolor rgb '#000000'\nset format '%h'\n"
    "set xtics 0.5 offset 0,-0.5\nset ytics 0.5 offset 0,-0.3\nset ztics 0.5 offset 1,0\n"
    "set autoscale fix\nset pm3d depthorder interpolate 4,4\n";

}  // namespace

std::filesystem::path draw(const SurfacePicture& picture, const std::filesystem::path& stem) {
  check(picture, stem.string());
  PlotItems items("splot");
  for (const Surface& surface : picture.surfaces) add_surface(surface, items);
  for (const Surface& surface : picture.surfaces) add_outline(surface, items);
  const auto [low, high] = range_of(picture);
  const std::string script =
      png_terminal() + stage + sequential_palette(bands) +
      fmt::format(
          "set cbrange [{}:{}]\nset xlabel {}\nset ylabel {} offset 0,-0.8\nset zlabel {}\nset "
          "cblabel {} offset "
          "1,0\n",
          low, high, quoted_text(picture.x_label), quoted_text(picture.y_label),
          quoted_text(picture.z_label), quoted_text(picture.value_label)) +
      items.command();
  std::filesystem::path png = stem.string() + ".png";
  run_gnuplot(script, items, png, png_ending);
  return png;
}

}  // namespace pennon::analysis

#include "analysis/drawing/surface_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/picture_style.hpp"

namespace pennon::analysis {
namespace {

constexpr int bands = 12;  // of colour

// What gnuplot reads in place of a file.
void append(std::string& data, std::initializer_list<double> numbers) {
  const std::size_t begin = data.size();
  data.resize(begin + numbers.size() * sizeof(double));
  std::memcpy(data.data() + begin, std::data(numbers), numbers.size() * sizeof(double));
}

struct Plot {
  std::string items, data;

  void add(const std::string& item) { items += (items.empty() ? "splot " : ", ") + item; }

  void add_surface(const Surface& s) {
    const std::size_t nodes = s.rows * s.columns;
    assert(s.x.size() == nodes && s.y.size() == nodes && s.z.size() == nodes &&
           s.values.size() == nodes);
    add(
        fmt::format("'-' binary record=({},{}) format='%double%double%double%double' "
                    "using 1:2:3:4 with pm3d notitle",
                    s.columns, s.rows));
    for (std::size_t n = 0; n < nodes; ++n) append(data, {s.x[n], s.y[n], s.z[n], s.values[n]});
  }

  void add_outline(const Surface& s) {
    std::vector<std::size_t> nodes;
    for (std::size_t j = 0; j < s.columns; ++j) nodes.push_back(j);
    for (std::size_t i = 1; i < s.rows; ++i) nodes.push_back((i + 1) * s.columns - 1);
    for (std::size_t j = s.columns - 1; j-- > 0;) nodes.push_back((s.rows - 1) * s.columns + j);
    for (std::size_t i = s.rows - 1; i-- > 0;) nodes.push_back(i * s.columns);
    add(
        fmt::format("'-' binary record=({}) format='%double%double%double' using 1:2:3 "
                    "with lines lc rgb '#000000' lw 0.5 notitle",
                    nodes.size()));
    for (const std::size_t n : nodes) append(data, {s.x[n], s.y[n], s.z[n]});
  }
};

// The ends of the colours; a single value gets a band around it.
std::pair<double, double> range_of(const SurfacePicture& picture) {
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const Surface& surface : picture.surfaces)
    for (const double value : surface.values) {
      low = std::min(low, value);
      high = std::max(high, value);
    }
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
  Plot plot;
  for (const Surface& surface : picture.surfaces) plot.add_surface(surface);
  for (const Surface& surface : picture.surfaces) plot.add_outline(surface);
  const auto [low, high] = range_of(picture);
  const std::string script =
      png_terminal() + stage + sequential_palette(bands) +
      fmt::format(
          "set cbrange [{}:{}]\nset xlabel {}\nset ylabel {} offset 0,-0.8\nset zlabel {}\nset "
          "cblabel {} offset "
          "1,0\n",
          low, high, quoted_text(picture.x_label), quoted_text(picture.y_label),
          quoted_text(picture.z_label), quoted_text(picture.value_label)) +
      plot.items + '\n' + plot.data;
  std::filesystem::path png = stem.string() + ".png";
  run_gnuplot(script, png, png_ending);
  return png;
}

}  // namespace pennon::analysis

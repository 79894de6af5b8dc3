#include "analysis/drawing/figure.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/drawing/frame.hpp"
#include "analysis/drawing/gnuplot.hpp"
#include "analysis/drawing/key_place.hpp"
#include "analysis/drawing/picture_style.hpp"
#include "analysis/drawing/raster.hpp"
#include "common/errors.hpp"

namespace pennon::analysis {
namespace {

// Okabe & Ito (2008), ordered so that the first few differ most, on paper and in grey.
constexpr std::array<const char*, 8> line_colors = {"#000000", "#0072B2", "#D55E00", "#009E73",
                                                    "#CC79A7", "#E69F00", "#56B4E9", "#F0E442"};

// About the pixels of the plot's area in the PNG.
constexpr std::size_t raster_columns = 1000;
constexpr std::size_t raster_rows = 800;

std::string title_of(const std::string& label) {
  return label.empty() ? "notitle" : "title " + quoted_text(label);
}

// An item of points (x, y).
void add_points(const std::string& style, const std::vector<double>& x,
                const std::vector<double>& y, PlotItems& items) {
  if (x.empty()) return;
  std::vector<double> pairs;
  for (std::size_t i = 0; i < x.size(); ++i) pairs.insert(pairs.end(), {x[i], y[i]});
  items.add(fmt::format("record=({}) format='%double%double' using 1:2 {}", x.size(), style),
            pairs);
}

const char* color_of(int index) {
  return line_colors[static_cast<std::size_t>(index) % line_colors.size()];
}

std::string dashes(Stroke stroke) {
  switch (stroke) {
    case Stroke::solid:
      return "solid";
    case Stroke::dashed:
      return "(9,5)";
    case Stroke::dotted:
      return "(2.5,4)";
    case Stroke::dash_dotted:
      return "(9,4,2,4)";
  }
  return "solid";
}

// How gnuplot draws a mark: the number of the filled one (the empty one is the number before), and
// the size at which all have about the same area.
struct Symbol {
  int number;
  double size;
};

Symbol symbol_of(Marker marker) {
  switch (marker) {
    case Marker::circle:
      return {7, 1.15};
    case Marker::square:
      return {5, 1.05};
    case Marker::triangle:
      return {9, 1.3};
    case Marker::diamond:
      return {13, 1.5};
  }
  return {7, 1.15};
}

void add_line(const Line& line, bool is_over_field, PlotItems& items) {
  // A light rim keeps a line apart from any colour under it.
  if (is_over_field)
    add_points(fmt::format("with lines lc rgb '#FFFFFF' lw {} notitle", line.width + 1.5), line.x,
               line.y, items);
  add_points(fmt::format("with lines lc rgb '{}' lw {} dt {} {}", color_of(line.color), line.width,
                         dashes(line.stroke), title_of(line.label)),
             line.x, line.y, items);
}

void add_marks(const Marks& marks, PlotItems& items) {
  const Symbol symbol = symbol_of(marks.marker);
  const auto add = [&](int number, const char* color, bool is_in_key) {
    add_points(fmt::format("with points pt {} ps {} lw 0.9 lc rgb '{}' {}", number, symbol.size,
                           color, title_of(is_in_key ? marks.label : std::string())),
               marks.x, marks.y, items);
  };
  constexpr const char* white = "#FFFFFF";
  const char* color = color_of(marks.color);
  add(symbol.number, marks.is_filled ? color : white, marks.is_filled);
  add(symbol.number - 1, marks.is_filled ? color_of(0) : color, !marks.is_filled);
}

void add_field(const Figure& figure, PlotItems& items) {
  const Raster image = raster(*figure.field, figure.x, figure.y, raster_columns, raster_rows);
  const double dx = (image.x_high - image.x_low) / static_cast<double>(image.columns);
  const double dy = (image.y_high - image.y_low) / static_cast<double>(image.rows);
  // On the second axes, which are linear in the coordinates as drawn: an image needs equal pixels.
  items.add(
      fmt::format("array=({},{}) format='%double' origin=({},{}) dx={} dy={} "
                  "axes x2y2 with image notitle",
                  image.columns, image.rows, image.x_low + dx / 2, image.y_low + dy / 2, dx, dy),
      image.values);
}

// The ends of the colours.
AxisRange colors_of(const FigureField& field) {
  AxisRange range{std::numeric_limits<double>::infinity(),
                  -std::numeric_limits<double>::infinity()};
  for (const double value : field.values) {
    if (!std::isfinite(value)) continue;
    range.low = std::min(range.low, value);
    range.high = std::max(range.high, value);
  }
  if (range.low > range.high) return {0, 1};
  if (field.is_diverging) {
    const double largest = std::max(std::abs(range.low), std::abs(range.high));
    return largest > 0 ? AxisRange{-largest, largest} : AxisRange{-1, 1};
  }
  const double margin = range.low == 0 ? 0.5 : 0.1 * std::abs(range.low);
  return range.low < range.high ? range : AxisRange{range.low - margin, range.high + margin};
}

std::string color_bar(const FigureField& field) {
  const AxisRange range = colors_of(field);
  return (field.is_diverging ? diverging_palette() : sequential_palette(0)) +
         fmt::format(
             "set cbrange [{}:{}]\nset cblabel {} offset 1,0\n"
             "set cbtics out scale 0.5 format '%h'\nset style line 1 lc rgb '#000000' lw 0.6\nset "
             "colorbox border 1\n",
             range.low, range.high, quoted_text(field.label));
}

// Labelled tics of a logarithmic axis too short for two powers of ten: 1, 2, 5 times a power, or
// equally spaced numbers where even those are too few.
std::string short_log_tics(double low, double high) {
  std::vector<std::string> tics;
  const auto add = [&](double value) {
    if (value >= low && value <= high) tics.push_back(fmt::format("{:.10g}", value));
  };
  if (high >= 5 * low) {
    const int lowest = static_cast<int>(std::floor(std::log10(low)));
    for (int exponent = lowest; exponent <= lowest + 2; ++exponent)
      for (const double digit : {1, 2, 5}) add(digit * std::pow(10, exponent));
  } else {
    const double power = std::pow(10, std::floor(std::log10(high - low)));
    const double step = high - low > 4 * power   ? power
                        : high - low > 2 * power ? power / 2
                                                 : power / 5;
    for (double i = std::ceil(low / step); i * step <= high; ++i) add(i * step);
  }
  return fmt::format("({})", fmt::join(tics, ", "));
}

std::string axis_text(const std::string& name, const FigureAxis& axis, const AxisRange& ends) {
  std::string text = fmt::format("set {}label {}\n", name, quoted_text(axis.label));
  text += fmt::format("set {}2range [{}:{}]\n", name, ends.low, ends.high);
  if (!axis.is_log)
    return text + fmt::format("set {}range [{}:{}]\nset format {} '%h'\n", name, ends.low,
                              ends.high, name);
  const double low = std::pow(10, ends.low);
  const double high = std::pow(10, ends.high);
  text += fmt::format("set logscale {} 10\nset {}range [{}:{}]\n", name, name, low, high);
  const bool shows_two_powers = std::floor(ends.high) - std::ceil(ends.low) >= 1;
  if (shows_two_powers) return text + fmt::format("set format {} '10^{{%L}}'\n", name);
  return text +
         fmt::format("set {0}tics {1}\nset format {0} '%h'\n", name, short_log_tics(low, high));
}

void check_grid_lines(const std::vector<double>& lines, const FigureAxis& axis, const char* name,
                      const std::string& picture) {
  if (lines.empty()) throw InputError(picture, fmt::format("has no grid line along {}", name));
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (!is_drawable(axis, lines[i]) || (i > 0 && lines[i] <= lines[i - 1]))
      throw InputError(picture,
                       fmt::format("number {} of the grid lines along {} is {}; they must "
                                   "be {}, below 1e300, and increase",
                                   i + 1, name, lines[i], axis.is_log ? "positive" : "finite"));
}

void check_count(std::size_t values, std::size_t points, const char* what,
                 const std::string& picture) {
  if (values != points)
    throw InputError(picture, fmt::format("{} has {} values for {} points", what, values, points));
}

// Throws InputError with the name of the picture.
void check(const Figure& figure, const std::string& picture) {
  if (const auto& field = figure.field) {
    check_grid_lines(field->x, figure.x, "x", picture);
    check_grid_lines(field->y, figure.y, "y", picture);
    check_count(field->values.size(), field->x.size() * field->y.size(), "the field", picture);
  }
  for (const Line& line : figure.lines)
    check_count(line.y.size(), line.x.size(), "a line", picture);
  for (const Marks& marks : figure.marks)
    check_count(marks.y.size(), marks.x.size(), "a row of marks", picture);
}

// What is drawn.
PlotItems items_of(const Figure& figure) {
  PlotItems items("plot");
  if (figure.field) add_field(figure, items);
  for (const Line& line : figure.lines) add_line(line, figure.field.has_value(), items);
  for (const Marks& marks : figure.marks) add_marks(marks, items);
  return items;
}

// The script between the choice of the picture's format and the plot command.
std::string settings_of(const Figure& figure) {
  const Frame frame = frame_of(figure);
  std::string text =
      "set encoding utf8\nset minussign\n"
      "set border 15 lw 0.6 front\nset tics out nomirror front scale 0.7\nset xlabel offset "
      "0,0.3\n";
  if (!figure.title.empty())
    text += fmt::format("set title {} noenhanced\n", quoted_text(figure.title));
  text += axis_text("x", figure.x, frame.x) + axis_text("y", figure.y, frame.y);
  text += key_command(figure, frame);
  if (figure.is_to_scale) text += "set size ratio -1\n";
  if (figure.field) text += color_bar(*figure.field);
  return text;
}

}  // namespace

std::string plain(std::string_view text) {
  std::string result;
  for (const char letter : text) {
    if (std::string_view("{}_^@&~\\").find(letter) != std::string_view::npos) result += '\\';
    result += letter;
  }
  return result;
}

std::vector<std::filesystem::path> draw(const Figure& figure, const std::filesystem::path& stem) {
  check(figure, stem.string());
  const PlotItems items = items_of(figure);
  const std::string script = settings_of(figure) + items.command();
  const std::filesystem::path png = stem.string() + ".png";
  const std::filesystem::path svg = stem.string() + ".svg";
  run_gnuplot(png_terminal() + script, items, png, png_ending);
  run_gnuplot(svg_terminal() + script, items, svg, svg_ending);
  return {png, svg};
}

}  // namespace pennon::analysis

/// Pictures a person would publish: lines, marks and a coloured field over two axes, drawn by
/// gnuplot to PNG and SVG.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace pennon::analysis {

struct FigureAxis {
  std::string label;  ///< plain text with gnuplot's markup for indices, e.g. "{/:Italic k_x} L"
  bool is_log = false;
  std::optional<double> low, high;  ///< none: fitted to what is drawn
};

enum class Stroke { solid, dashed, dotted, dash_dotted };
enum class Marker { circle, square, triangle, diamond };

struct Line {
  std::vector<double> x, y;  ///< equally long; a NaN breaks the line
  std::string label;         ///< in the key; not there if empty
  Stroke stroke = Stroke::solid;
  int color = 0;             ///< index into a palette that colour-blind readers can tell apart; 0 is black
  double width = 1.5;
};

struct Marks {
  std::vector<double> x, y;
  std::string label;
  Marker marker = Marker::square;
  bool is_filled = true;
  int color = 0;
};

/// Values on the nodes of a rectangular grid, coloured.
struct Field {
  std::vector<double> x, y;    ///< the grid's lines, increasing, not necessarily equally spaced
  std::vector<double> values;  ///< y.size() rows of x.size() values; NaN is left blank
  std::string label;           ///< of the colour bar
  bool is_diverging = false;   ///< colours centred on zero
};

struct Figure {
  std::string title;
  FigureAxis x, y;
  std::optional<Field> field;
  std::vector<Line> lines;
  std::vector<Marks> marks;
};

/// Writes `stem`.png and, where the figure has no field of more than 10^5 points, `stem`.svg, each
/// whole or not at all. Returns the files written. Throws FileError if gnuplot is missing or fails,
/// with its own words.
std::vector<std::filesystem::path> draw(const Figure&, const std::filesystem::path& stem);

}  // namespace pennon::analysis

/// Pictures a person would publish: lines, marks and a coloured field over two axes, drawn by
/// gnuplot to PNG and SVG.
///
/// Labels are gnuplot's enhanced text, for italics and indices, with Greek letters as such:
/// "frequency {/:Italic ω_1}". A text that comes from a user (a name, a file) goes through plain()
/// before it becomes part of a label; the title is taken literally and needs nothing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pennon::analysis {

struct FigureAxis {
  std::string label;                ///< enhanced text
  bool is_log = false;              ///< leaves out what is not positive
  std::optional<double> low, high;  ///< low < high; none: fitted to what is drawn
};

enum class Stroke { solid, dashed, dotted, dash_dotted };
enum class Marker { circle, square, triangle, diamond };

struct Line {
  std::vector<double> x, y;  ///< equally long; a NaN breaks the line
  std::string label;         ///< enhanced text in the key; not there if empty
  Stroke stroke = Stroke::solid;
  int color = 0;  ///< index into a palette that colour-blind readers can tell apart; 0 is black
  double width = 1.5;
};

struct Marks {
  std::vector<double> x, y;  ///< equally long
  std::string label;         ///< as a line's
  Marker marker = Marker::square;
  bool is_filled = true;
  int color = 0;
};

/// Values on the nodes of a rectangular grid, coloured; between nodes they are interpolated
/// linearly along the axes as drawn.
struct FigureField {
  std::vector<double> x, y;    ///< the grid's lines, increasing, not necessarily equally spaced
  std::vector<double> values;  ///< y.size() rows of x.size() values; NaN is left blank
  std::string label;           ///< of the colour bar, enhanced text
  bool is_diverging = false;   ///< colours centred on zero
};

struct Figure {
  std::string title;  ///< literal text; none if empty
  FigureAxis x, y;
  std::optional<FigureField> field;
  std::vector<Line> lines;
  std::vector<Marks> marks;
  bool is_to_scale = false;  ///< one length for one unit along both axes
};

/// The text as enhanced text that shows it letter by letter.
std::string plain(std::string_view text);

/// Writes `stem`.png and `stem`.svg, each whole or not at all, and returns their names. A field is
/// drawn on a raster, so that neither time nor size grow with its grid. Points that are not finite
/// are left out. Throws InputError where a field's grid lines cannot be drawn on their axis or do
/// not increase, or where there is another number of values than points; FileError, with gnuplot's
/// own words, if it is missing or fails.
std::vector<std::filesystem::path> draw(const Figure&, const std::filesystem::path& stem);

}  // namespace pennon::analysis

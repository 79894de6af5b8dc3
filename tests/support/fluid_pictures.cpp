/// Draws the pictures of the fluid in docs/accuracy.md from data/reference/pennon:
/// fluid_pictures FOLDER
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "analysis/drawing/figure.hpp"
#include "common/io/csv.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/tool.hpp"

namespace pennon {
namespace {

using analysis::Figure;

const std::filesystem::path reference = test::source_folder() / "data/reference/pennon";

double number(const CsvTable& table, std::size_t row, const std::string& column) {
  return table.number(row, table.column(column)).value_or(NAN);
}

// The finest grid's drag over Re, between the two theories.
Figure drag() {
  const CsvTable table(reference / "fluid_plate_drag.csv");
  Figure figure;
  figure.title = "Drag of a plate along the stream, both sides";
  figure.x = {"{/:Italic Re}", true, 80, 1250};
  figure.y = {"{/:Italic C_D}", true, 0.07, 0.5};
  analysis::Line blasius, triple_deck;
  blasius.label = "Blasius";
  blasius.stroke = analysis::Stroke::dashed;
  triple_deck.label = "Blasius and the trailing edge's triple deck";
  constexpr int points = 50;
  for (int n = 0; n <= points; ++n) {
    const double Re = 80 * std::pow(1250.0 / 80, static_cast<double>(n) / points);
    const double plain = 2.656 / std::sqrt(Re);
    for (analysis::Line* line : {&blasius, &triple_deck}) line->x.push_back(Re);
    blasius.y.push_back(plain);
    triple_deck.y.push_back(plain + 5.34 * std::pow(Re, -7.0 / 8));
  }
  analysis::Marks coarse, fine;
  coarse.label = "30 x 60 cells";
  coarse.is_filled = false;
  fine.label = "120 x 240 cells";
  fine.marker = analysis::Marker::circle;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double n_rho = number(table, row, "n_rho");
    if (n_rho == 60) continue;
    analysis::Marks& marks = n_rho == 30 ? coarse : fine;
    marks.x.push_back(number(table, row, "Re"));
    marks.y.push_back(number(table, row, "C_D"));
  }
  figure.lines = {blasius, triple_deck};
  figure.marks = {coarse, fine};
  return figure;
}

// The amplitude of the lift over Theodorsen's.
Figure lift(bool pitches) {
  const CsvTable table(reference / "fluid_theodorsen.csv");
  Figure figure;
  figure.title = pitches ? "Lift of a pitching plate over Theodorsen's"
                         : "Lift of a plunging plate over Theodorsen's";
  figure.x = {"reduced frequency {/:Italic k}", true, 0.4, 6};
  figure.y = {"amplitude over Theodorsen's", false, 0.6, 1.1};
  figure.lines.push_back({{0.4, 6}, {1, 1}, "", analysis::Stroke::dotted});
  int color = 1;
  for (const double Re : {1000.0, 4000.0, 16000.0}) {
    analysis::Line line;
    line.label = fmt::format("{{/:Italic Re}} = {:g}", Re);
    line.color = color++;
    for (std::size_t row = 0; row < table.rows(); ++row) {
      if (number(table, row, "Re") != Re || (number(table, row, "pitches") != 0) != pitches)
        continue;
      line.x.push_back(number(table, row, "k"));
      line.y.push_back(number(table, row, "lift"));
    }
    figure.lines.push_back(line);
  }
  return figure;
}

void draw_all(char** argv) {
  const std::filesystem::path folder = argv[1];
  draw(drag(), folder / "fluid-plate-drag");
  draw(lift(false), folder / "fluid-plunge-lift");
  draw(lift(true), folder / "fluid-pitch-lift");
}

}  // namespace
}  // namespace pennon

int main(int argc, char** argv) {
  return pennon::test::run_tool(argc, argv, 2, "fluid_pictures FOLDER", pennon::draw_all);
}

/// Draws the pictures of the coupled flag in docs/accuracy.md from data/reference/pennon:
/// coupled_pictures FOLDER
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <numbers>

#include "analysis/drawing/figure.hpp"
#include "common/io/csv.hpp"
#include "lsa/evaluate.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/tool.hpp"

namespace pennon {
namespace {

using analysis::Figure;
using analysis::Line;
using analysis::Marks;

const std::filesystem::path reference = test::source_folder() / "data/reference/pennon";

// The growth of one wave along the span over its wavenumber: the simulation's, and the local
// theory's as the paper's figure 5 has it.
Figure growth_of_a_wave() {
  Figure figure;
  figure.title = "Growth of one wave along the span, Re = 1000";
  figure.x = {"{/:Italic k_x L}", false, -0.2, 6.6};
  figure.y = {"growth rate σ, in {/:Italic V/L}", false, -0.8, 1.1};
  figure.lines.push_back({{-0.2, 6.6}, {0, 0}, "", analysis::Stroke::dotted});
  const CsvTable table(reference / "coupled_figure5.csv");
  const std::vector<double> mu = table.numbers("mu"), gamma = table.numbers("gamma"),
                            sigma = table.numbers("sigma");
  int color = 1;
  for (const double of_mu : {0.125, 0.075, 0.025}) {
    Line theory;
    theory.label = fmt::format("local theory, μ = {:g}", of_mu);
    theory.color = color;
    theory.stroke = analysis::Stroke::dashed;
    for (int n = 1; n <= 100; ++n) {
      const double k_x = 2 * std::numbers::pi * n / 100;
      theory.x.push_back(k_x);
      theory.y.push_back(
          solve({of_mu, 1000, k_x, std::numbers::pi, 0.3, 0, 0}, lsa::Theory{}).growth);
    }
    Marks simulation;
    simulation.label = fmt::format("simulation, μ = {:g}", of_mu);
    simulation.color = color++;
    simulation.marker = analysis::Marker::circle;
    for (std::size_t row = 0; row < mu.size(); ++row) {
      if (mu[row] != of_mu || !std::isfinite(sigma[row])) continue;
      simulation.x.push_back(gamma[row] > 0 ? 2 * std::numbers::pi / gamma[row] : 0);
      simulation.y.push_back(sigma[row]);
    }
    figure.lines.push_back(theory);
    figure.marks.push_back(simulation);
  }
  return figure;
}

// Passes of the coupling over the mass ratio, for each time step.
Figure passes() {
  Figure figure;
  figure.title = "Passes of the coupling from the start to t = 1.5";
  figure.x = {"{/:Italic μ}", true, 8e-4, 12};
  figure.y = {"passes a step, mean", false, 1, 3};
  const CsvTable table(reference / "coupled_robustness.csv");
  const std::vector<double> mu = table.numbers("mu"), dt = table.numbers("dt"),
                            mean = table.numbers("passes_mean");
  int color = 1;
  for (const double of_dt : {0.0005, 0.001, 0.002, 0.004, 0.008}) {
    Line line;
    line.label = fmt::format("Δ{{/:Italic t}} = {:g}", of_dt);
    line.color = color++;
    for (std::size_t row = 0; row < mu.size(); ++row) {
      if (dt[row] != of_dt) continue;
      line.x.push_back(mu[row]);
      line.y.push_back(mean[row]);
    }
    figure.lines.push_back(line);
  }
  return figure;
}

// Figure 25: the trailing edge's antinode of the case of Table 2.
Figure trailing_edge_over_Re() {
  Figure figure;
  figure.title = "Trailing edge at its antinode, one wave along a span of 5 L";
  figure.x = {"{/:Italic tV/L}", false, 0, 9};
  figure.y = {"{/:Italic ζ/L}", false, -0.3, 0.3};
  int color = 1;
  for (const auto& [name, Re] :
       {std::pair{"table2_Re500", 500}, {"table2_Re800", 800}, {"table2", 1000}}) {
    const CsvTable run(reference / "runs" / fmt::format("{}.csv", name));
    figure.lines.push_back({run.numbers("t"), run.numbers("z_antinode"),
                            fmt::format("{{/:Italic Re}} = {}", Re),
                            static_cast<analysis::Stroke>(color - 1), color});
    ++color;
  }
  return figure;
}

// Figure 26: the four energies of the case of Table 2 on three grids.
Figure energies_on_three_grids() {
  Figure figure;
  figure.title = "Energies per span of the case of Table 2";
  figure.x = {"{/:Italic tV/L}", false, 0, 9};
  figure.y = {"energy, in {/:Italic ρ_f V^2 L^2}", true, 1e-6, 1};
  struct Grid {
    const char *name, *label;
    analysis::Stroke stroke;
  };
  constexpr std::array<Grid, 3> grids = {{{"table2_fine", "80 x 160", analysis::Stroke::solid},
                                          {"table2", "60 x 120", analysis::Stroke::dotted},
                                          {"table2_coarse", "40 x 80", analysis::Stroke::dashed}}};
  const std::array<std::pair<const char*, const char*>, 4> energies = {
      {{"fluid", "fluid, kinetic"},
       {"flag_kinetic", "flag, kinetic"},
       {"bending", "bending"},
       {"stretch", "stretch"}}};
  for (const Grid& grid : grids) {
    const CsvTable run(reference / "runs" / fmt::format("{}.csv", grid.name));
    int color = 1;
    for (const auto& [column, label] : energies)
      figure.lines.push_back({run.numbers("t"), run.numbers(column),
                              fmt::format("{}, {}", label, grid.label), grid.stroke, color++});
  }
  return figure;
}

void draw_all(char** argv) {
  const std::filesystem::path folder = argv[1];
  draw(growth_of_a_wave(), folder / "coupled-growth-over-k_x");
  draw(passes(), folder / "coupled-passes");
  draw(trailing_edge_over_Re(), folder / "coupled-figure25");
  draw(energies_on_three_grids(), folder / "coupled-figure26");
}

}  // namespace
}  // namespace pennon

int main(int argc, char** argv) {
  return pennon::test::run_tool(argc, argv, 2, "coupled_pictures FOLDER", pennon::draw_all);
}

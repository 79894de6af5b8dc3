#include "analysis/figures/of_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/figures/result_parts.hpp"
#include "analysis/signal/series.hpp"

namespace pennon::analysis {
namespace {

constexpr std::size_t waves_drawn = 4;
// Profiles of a waterfall, and how far the largest displacement shifts one, in gaps between them.
constexpr std::size_t profiles_drawn = 150;
constexpr double largest_shift = 2;
// Times of a map over time and span.
constexpr std::size_t times_drawn = 1200;

const char* const time_label = "{/:Italic tV}/{/:Italic L}";
const char* const span_label = "{/:Italic x}/{/:Italic L}";
const char* const energy_unit = " / {/:Italic ρ_f V}^{ 2}{/:Italic L}^{ 2}";

Figure over_time(const RunAnalysis& found, std::string label) {
  Figure figure;
  figure.x = {time_label, false, std::min(0.0, found.run.t.front()), found.run.t.back()};
  figure.y.label = std::move(label);
  return figure;
}

// The fitted growth, A exp(sigma (t - from)), in its window.
Line fitted_envelope(const Growth& growth, double sign, std::string label) {
  Line line{{}, {}, std::move(label), Stroke::dashed, 2, 1.5};
  line.x = equal_times(growth.from, growth.to, 100);
  for (const double t : line.x)
    line.y.push_back(sign * growth.amplitude * std::exp(growth.sigma * (t - growth.from)));
  return line;
}

std::string growth_label(const Growth& growth) {
  return fmt::format("{{/:Italic σ}} = {:.3g}, {{/:Italic ω}} = {:.3g}", growth.sigma,
                     growth.omega);
}

// The profile along the whole span, closed by the first station.
std::vector<double> profile(const RunHistory& run, const std::vector<Spline>& stations, double t) {
  std::vector<double> z;
  for (std::size_t m = 0; m <= run.planes(); ++m) z.push_back(stations[m % run.planes()](t));
  return z;
}

std::vector<Spline> splines(const RunHistory& run) {
  std::vector<Spline> stations;
  for (const std::vector<double>& z : run.z) stations.emplace_back(run.t, z);
  return stations;
}

std::vector<double> closed_span(const RunHistory& run) {
  return equal_times(0, run.span, run.planes() + 1);
}

double largest_displacement(const RunHistory& run) {
  double largest = 0;
  for (const std::vector<double>& station : run.z)
    for (const double z : station) largest = std::max(largest, std::abs(z));
  return largest;
}

}  // namespace

Figure figure_of_trailing_edge(const RunAnalysis& found) {
  Figure figure = over_time(found, "{/:Italic ζ}/{/:Italic L}");
  figure.lines.push_back(
      {found.run.t, found.run.z[antinode_of(found.run)], "", Stroke::solid, 0, 1.2});
  if (const auto& growth = found.linear.growth) {
    figure.lines.push_back(fitted_envelope(*growth, 1, growth_label(*growth)));
    figure.lines.push_back(fitted_envelope(*growth, -1, ""));
  }
  return figure;
}

Figure figure_of_growth(const RunAnalysis& found) {
  Figure figure =
      over_time(found, fmt::format("|{{/:Italic ζ}}_{}|/{{/:Italic L}}", found.linear.wave));
  figure.y.is_log = true;
  Line size{found.run.t, {}, "", Stroke::solid, 0, 1};
  double largest = 0;
  for (const auto& value : found.components[found.linear.wave]) {
    size.y.push_back(std::abs(value));
    largest = std::max(largest, std::abs(value));
  }
  const Line fit = fitted_envelope(*found.linear.growth, 1, growth_label(*found.linear.growth));
  // Passages through zero go down without end on this axis: what is below the fit's hundredth tells
  // nothing.
  figure.y.low = std::min(fit.y.front(), fit.y.back()) / 100;
  figure.y.high = 2 * std::max({largest, fit.y.front(), fit.y.back()});
  figure.lines.push_back(std::move(size));
  figure.lines.push_back(fit);
  return figure;
}

Figure figure_of_spanwise_amplitudes(const RunAnalysis& found) {
  Figure figure = over_time(found, "|{/:Italic ζ_n}|/{/:Italic L}");
  figure.y.low = 0;
  const std::vector<std::vector<double>> sizes = moduli(found.components);
  for (std::size_t n = 0; n < std::min(waves_drawn, sizes.size()); ++n)
    figure.lines.push_back({found.run.t, sizes[n], fmt::format("{{/:Italic n}} = {}", n),
                            Stroke::solid, static_cast<int>(n), 1.2});
  return figure;
}

Figure figure_of_waterfall(const RunAnalysis& found) {
  Figure figure = over_time(found, span_label);
  const RunHistory& run = found.run;
  const double gap = (run.t.back() - run.t.front()) / static_cast<double>(profiles_drawn - 1);
  const double largest = largest_displacement(run);
  const double scale = largest > 0 ? gap * largest_shift / largest : 0;
  const std::vector<Spline> stations = splines(run);
  for (const double t : equal_times(run.t.front(), run.t.back(), profiles_drawn)) {
    Line line{profile(run, stations, t), closed_span(run), "", Stroke::solid, 0, 0.6};
    for (double& x : line.x) x = t + scale * x;
    figure.lines.push_back(std::move(line));
  }
  figure.y.low = 0;
  figure.y.high = run.span;
  return figure;
}

Figure figure_of_space_and_time(const RunAnalysis& found) {
  Figure figure = over_time(found, span_label);
  const RunHistory& run = found.run;
  FigureField field{equal_times(run.t.front(), run.t.back(), times_drawn),
                    closed_span(run),
                    {},
                    "{/:Italic ζ}/{/:Italic L}",
                    true};
  field.values.resize(field.x.size() * field.y.size());
  const std::vector<Spline> stations = splines(run);
  for (std::size_t i = 0; i < field.x.size(); ++i) {
    const std::vector<double> z = profile(run, stations, field.x[i]);
    for (std::size_t m = 0; m < z.size(); ++m) field.values[m * field.x.size() + i] = z[m];
  }
  figure.field = std::move(field);
  return figure;
}

Figure figure_of_forces(const RunAnalysis& found) {
  Figure figure = over_time(found, "force coefficient");
  figure.lines.push_back(
      {found.run.t, found.run.column("C_D"), "{/:Italic C_D}", Stroke::solid, 1, 1.2});
  figure.lines.push_back(
      {found.run.t, found.run.column("C_L"), "{/:Italic C_L}", Stroke::solid, 2, 1.2});
  return figure;
}

Figure figure_of_flag_energy(const RunAnalysis& found) {
  Figure figure = over_time(found, std::string("energy of the flag") + energy_unit);
  const EnergyBudget& e = found.energy;
  figure.lines.push_back({e.t, e.flag_kinetic, "kinetic", Stroke::solid, 1, 1.2});
  figure.lines.push_back({e.t, e.bending, "bending", Stroke::solid, 2, 1.2});
  figure.lines.push_back({e.t, e.stretch, "stretch", Stroke::solid, 3, 1.2});
  if (has_nonzero(e.gravity))
    figure.lines.push_back({e.t, e.gravity, "gravitational", Stroke::solid, 4, 1.2});
  figure.lines.push_back({e.t, e.flag, "total", Stroke::solid, 0, 1.5});
  return figure;
}

Figure figure_of_energy_budget(const RunAnalysis& found) {
  Figure figure = over_time(found, std::string("energy") + energy_unit);
  const EnergyBudget& e = found.energy;
  figure.lines.push_back({e.t, e.total, "flag and fluid", Stroke::solid, 0, 1.5});
  figure.lines.push_back({e.t, e.received, "received", Stroke::dashed, 1, 1.2});
  figure.lines.push_back({e.t, e.lost, "dissipated", Stroke::dash_dotted, 2, 1.2});
  figure.lines.push_back({e.t, e.defect, "defect", Stroke::solid, 3, 1.2});
  return figure;
}

std::vector<std::filesystem::path> draw_run(const RunAnalysis& found,
                                            const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> pictures;
  const auto add = [&](const Figure& figure, const char* name) {
    const std::vector<std::filesystem::path> drawn = draw(figure, folder / name);
    pictures.insert(pictures.end(), drawn.begin(), drawn.end());
  };
  add(figure_of_trailing_edge(found), "trailing_edge");
  if (found.linear.growth) add(figure_of_growth(found), "growth");
  if (found.run.has_span()) {
    add(figure_of_spanwise_amplitudes(found), "spanwise_amplitudes");
    add(figure_of_waterfall(found), "waterfall");
    add(figure_of_space_and_time(found), "space_and_time");
  }
  add(figure_of_forces(found), "forces");
  add(figure_of_flag_energy(found), "flag_energy");
  add(figure_of_energy_budget(found), "energy_budget");
  return pictures;
}

}  // namespace pennon::analysis

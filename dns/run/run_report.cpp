#include "dns/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::dns {
namespace {

using Json = nlohmann::ordered_json;

double nanoseconds_per_cell_and_step(const FluidRunResult& result) {
  constexpr double nanoseconds = 1e9;
  return nanoseconds * result.loop.step_seconds /
         static_cast<double>(std::max<std::int64_t>(result.loop.steps, 1)) /
         static_cast<double>(result.cells);
}

// The number of a column in a row.
template <class Columns, class Row>
double value(const Columns& columns, const Row& row, std::string_view name) {
  const auto found = std::ranges::find_if(
      columns, [&](const HistoryColumn& column) { return column.name == name; });
  return row[static_cast<std::size_t>(found - columns.begin())];
}

template <class Columns, class Row>
void add(const Columns& columns, const Row& row, Json& json) {
  for (std::size_t c = 0; c < columns.size(); ++c) json[columns[c].name] = row[c];
}

// The names of what is refined and of what converges, in files.
const char* size_name(Refinement refinement) {
  return refinement == Refinement::step ? "dt" : "n";
}
const char* value_name(Refinement refinement) {
  return refinement == Refinement::step ? "frequency" : "deflection";
}

}  // namespace

Json to_json(const FlagRunResult& result) {
  const LoopSummary& loop = result.loop;
  Json json = {
      {"status", result.status},        {"t_end", loop.t_end},  {"steps", loop.steps},
      {"wall_s", result.wall_seconds},  {"cells", 0},           {"ns_per_cell_step", nullptr},
      {"coupling_iterations", nullptr}, {"checkpoint", nullptr}};
  if (!loop.checkpoint.empty()) json["checkpoint"] = loop.checkpoint;
  json["nodes"] = result.nodes;
  json["newton_iterations"] = {{"mean", result.iterations_mean}, {"max", result.iterations_max}};
  json["halved_steps"] = result.halved_steps;
  add(columns_of_history(), result.rows.back(), json["last"]);
  return json;
}

Json to_json(const FluidRunResult& result) {
  const LoopSummary& loop = result.loop;
  Json json = {
      {"status", "done"},
      {"t_end", loop.t_end},
      {"steps", loop.steps},
      {"wall_s", result.wall_seconds},
      {"cells", result.cells},
      {"ns_per_cell_step", nanoseconds_per_cell_and_step(result)},
      {"coupling_iterations", nullptr},
      {"checkpoint", loop.checkpoint},
      {"pressure_iterations",
       {{"mean", result.pressure_iterations_mean}, {"max", result.pressure_iterations_max}}},
      {"least_area", result.least_area},
      {"largest_wall_area", result.largest_wall_area}};
  if (result.is_coupled)
    json["coupling_iterations"] = {{"mean", result.passes_mean}, {"max", result.passes_max}};
  if (result.last_of_flag) add(columns_of_coupled_flag(), *result.last_of_flag, json["last"]);
  add(columns_of_fluid_history(), result.last, json["last"]);
  return json;
}

Json to_json(const Convergence& convergence) {
  Json json;
  if (convergence.refinement == Refinement::step)
    json["dt"] = convergence.sizes;
  else
    json["n"] = std::vector<std::int64_t>(convergence.sizes.begin(), convergence.sizes.end());
  json[value_name(convergence.refinement)] = convergence.values;
  json["limit"] = convergence.limit;
  json["limit_is_given"] = convergence.is_limit_given;
  json["order"] = convergence.order;
  return json;
}

std::string text_of(const FlagRunResult& result) {
  const auto last = [&](const char* name) {
    return value(columns_of_history(), result.rows.back(), name);
  };
  std::string text = fmt::format(
      "  {}: {} nodes, {} steps to t = {:.6g} in {:.3g} s, Newton iterations {:.2f} on average, {} "
      "at most\n",
      result.status, result.nodes, result.loop.steps, result.loop.t_end, result.wall_seconds,
      result.iterations_mean, result.iterations_max);
  if (result.halved_steps > 0)
    text += fmt::format("  {} steps had to be halved\n", result.halved_steps);
  text += fmt::format("  probe at ({:.6g}, {:.6g}, {:.6g}); strains {:.3g} to {:.3g}\n", last("x"),
                      last("y"), last("z"), last("least_strain"), last("greatest_strain"));
  return text;
}

std::string text_of(const FluidRunResult& result, double wall_spacing) {
  const auto last = [&](const char* name) {
    return value(columns_of_fluid_history(), result.last, name);
  };
  std::string text = fmt::format(
      "  done: {} cells, {} steps to t = {:.6g} in {:.3g} s, {:.3g} ns per cell and step\n"
      "  pressure iterations {:.2f} on average, {} at most; least area of a cell {:.3f} of that at "
      "rest\n"
      "  C_D = {:.6g}, C_L = {:.6g}, energy defect {:.3g}\n",
      result.cells, result.loop.steps, result.loop.t_end, result.wall_seconds,
      nanoseconds_per_cell_and_step(result), result.pressure_iterations_mean,
      result.pressure_iterations_max, result.least_area, last("C_D"), last("C_L"),
      last("energy_defect"));
  constexpr double much_thicker = 3;
  if (result.largest_wall_area > much_thicker)
    text += fmt::format(
        "  cells at the flag grew to {:.1f} times their thickness at rest, so the flow there is "
        "resolved as with dns.wall_spacing = {:.3g}; a smaller dns.wall_spacing shows whether that "
        "matters\n",
        result.largest_wall_area, result.largest_wall_area * wall_spacing);
  if (result.is_coupled)
    text += fmt::format(
        "  z of the trailing edge {:.6g}; coupling passes {:.2f} on average, {} at most\n",
        last("z_trailing_edge"), result.passes_mean, result.passes_max);
  return text;
}

std::string title_of(const Convergence& found) {
  return found.refinement == Refinement::step ? "a vibration with several time steps"
                                              : "equilibria on several grids";
}

std::string text_of(const Convergence& found) {
  std::string text =
      fmt::format("  {:>7} {:>14}\n", size_name(found.refinement), value_name(found.refinement));
  for (std::size_t k = 0; k < found.sizes.size(); ++k)
    text += fmt::format("  {:7} {:14.8g}\n", found.sizes[k], found.values[k]);
  return text + fmt::format("  {} {:.8g}; the error falls with the power {:.2f} of the {}\n",
                            found.is_limit_given ? "reference" : "extrapolated", found.limit,
                            found.order,
                            found.refinement == Refinement::step ? "time step" : "spacing");
}

void write(const Convergence& c, const OutputFolder& folder) {
  const std::string value = value_name(c.refinement);
  const bool is_step = c.refinement == Refinement::step;
  std::vector<double> h, error;
  CsvText table(is_step ? "angular frequency of the probe by the time step, in V/L"
                        : "deflection of the probe by the nodes along each side, in L",
                {size_name(c.refinement), "spacing", value, "error"});
  for (std::size_t k = 0; k < c.values.size(); ++k) {
    h.push_back(c.spacing(k));
    error.push_back(std::abs(c.values[k] - c.limit));
    table.row({c.sizes[k], h.back(), c.values[k], error.back()});
  }
  write_file(folder / "convergence.csv", table.text());
  hdf5::Writer file(folder / "convergence.h5");
  file.attributes(
      {{"kind", "flag_convergence"}, {"of", value}, {"limit", c.limit}, {"order", c.order}});
  const std::string unit = is_step ? ", in V/L" : ", in L";
  file.write("/h", {h.size()}, h, {{"meaning", is_step ? "time step, in L/V" : "1/(n - 1)"}});
  file.write("/" + value, {h.size()}, c.values,
             {{"meaning", (is_step ? "angular frequency of the probe" : "z of the probe") + unit}});
  file.write("/error", {h.size()}, error, {{"meaning", "|" + value + " - limit|" + unit}});
  file.finish();
}

}  // namespace pennon::dns

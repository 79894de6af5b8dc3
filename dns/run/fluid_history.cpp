#include "dns/run/fluid_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/parallel/ranks.hpp"
#include "dns/grid/grid_point.hpp"

namespace pennon::dns {
namespace {

constexpr std::size_t values_of_station = 3, values_of_probe = 4;
// The columns that the defect of energy is made of.
constexpr std::size_t t_column = 0, kinetic_column = 7, dissipation_column = 8, wall_column = 9,
                      outer_column = 10, defect_column = 11;

double power(const FluidRow& row) {
  return row[wall_column] - row[dissipation_column] + row[outer_column];
}

void append(const std::vector<double>& values, std::vector<double>& all) {
  all.insert(all.end(), values.begin(), values.end());
}

std::vector<HistoryColumn> columns_of(const FluidHistory& history) {
  std::vector<HistoryColumn> columns(columns_of_fluid_history().begin(),
                                     columns_of_fluid_history().end());
  if (!history.flag.empty())
    columns.insert(columns.end(), columns_of_coupled_flag().begin(),
                   columns_of_coupled_flag().end());
  return columns;
}

std::vector<double> row_of(const FluidHistory& history, std::size_t r) {
  std::vector<double> row(history.rows[r].begin(), history.rows[r].end());
  if (!history.flag.empty()) row.insert(row.end(), history.flag[r].begin(), history.flag[r].end());
  return row;
}

void write_arrays(const FluidHistory& history, int planes, std::size_t probes, hdf5::Writer& file) {
  const std::vector<HistoryColumn> columns = columns_of(history);
  std::vector<double> values;
  for (std::size_t r = 0; r < history.rows.size(); ++r) append(row_of(history, r), values);
  const hsize_t rows = history.rows.size();
  file.write("/history", {rows, columns.size()}, values, attributes_of(columns));
  file.write("/stations", {rows, static_cast<hsize_t>(planes), values_of_station}, history.stations,
             {{"meaning", "drag, lift and side force of each plane, in rho_f V^2 L per span"}});
  if (!history.flag.empty())
    file.write("/trailing_edge", {rows, static_cast<hsize_t>(planes), values_of_station},
               history.trailing_edge,
               {{"meaning", "position x, y, z of the trailing edge at each station, in L"}});
  if (probes == 0) return;
  file.write("/probes", {rows, probes, static_cast<hsize_t>(planes), values_of_probe},
             history.probes, {{"meaning", "v, w, u, p, in V and rho_f V^2"}});
}

}  // namespace

const std::array<HistoryColumn, fluid_columns>& columns_of_fluid_history() {
  static const std::array<HistoryColumn, fluid_columns> columns = {{
      {"t", "time, in L/V"},
      {"dt", "the step that led here, in L/V"},
      {"z_trailing_edge", "z of the trailing edge in the first plane, in L"},
      {"C_D", "drag of both sides on 1/2 rho_f V^2 L S"},
      {"C_L", "lift, force along z, on the same"},
      {"C_S", "side force, along x, on the same"},
      {"C_D_friction", "the share of friction in C_D"},
      {"kinetic", "kinetic energy of the velocity less the stream, in rho_f V^2 L^2 per span"},
      {"dissipation", "rate, in rho_f V^3 L per span"},
      {"wall_power", "of the flag on the fluid, in the same unit"},
      {"outer_power",
       "energy entering through the outer boundary, by flow and pressure, in the same unit"},
      {"energy_defect",
       "kinetic energy gained since the first row, less the integral of wall_power - dissipation + "
       "outer_power: the method's error, in rho_f V^2 L^2 per span"},
      {"momentum_y", "of the velocity less the stream, in rho_f V L^2 per span"},
      {"momentum_z", "of the velocity less the stream, in rho_f V L^2 per span"},
      {"outer_force_y",
       "momentum entering through the outer boundary, by flow and pressure, in rho_f V^2 L per "
       "span"},
      {"pressure_iterations", "of the step"},
      {"velocity_iterations", "of the step, the most of a component"},
      {"grid_passes", "of the step, the most of a plane"},
      {"least_area", "of a cell, over its area at rest"},
      {"largest_wall_area",
       "of a cell at the flag, over its area at rest: how much thicker it has become"},
      {"CFL", "largest Courant number of the step"},
  }};
  return columns;
}

const std::array<HistoryColumn, coupled_columns>& columns_of_coupled_flag() {
  static const std::array<HistoryColumn, coupled_columns> columns = {{
      {"flag_kinetic", "kinetic energy of the flag, in rho_f V^2 L^2 per span"},
      {"bending", "bending energy of the flag, in the same unit"},
      {"stretch_2d", "energy of its chordwise strain, in the same unit"},
      {"stretch_3d", "what the span adds to the energy of stretch, in the same unit"},
      {"gravity", "gravitational energy of the flag, in the same unit"},
      {"damping_dissipated", "by the flag's damping since the start, in the same unit"},
      {"fluid_work", "of the fluid and a kick on the flag since the start, in the same unit"},
      {"flag_defect",
       "energies of the flag gained since the first row, with the dissipated, less the work: the "
       "method's error, in the same unit"},
      {"coupling_passes", "of the step"},
      {"coupling_residual", "pressure jump that the last pass left, root mean square, rho_f V^2"},
      {"least_strain", "of all segments"},
      {"greatest_strain", "of all segments"},
  }};
  return columns;
}

void add_row(const Fluid& fluid, const FluidState& state, const FluidStepSummary& summary,
             const ProbeSettings& probes, FluidHistory& history) {
  const WallTraction traction = wall_traction(fluid, state);
  const Vector3 force = total_force(fluid, traction);
  const FluidBudget budget = fluid_budget(fluid, state, traction);
  double pressure_drag = 0;
  const FaceMetrics<double>& faces = fluid.metrics().rho_faces;
  const int planes = fluid.extent().planes, n_theta = fluid.extent().n_theta;
  for (int plane = 0; plane < planes; ++plane)
    for (int i = 0; i < n_theta; ++i)
      pressure_drag -= 2 * traction.pressure[fluid.extent().wall_face(plane, i)] *
                       faces.area_y.row(plane, 0)[i] / fluid.span().planes();
  pressure_drag = ranks::sum(pressure_drag);
  FluidRow row = {state.t,
                  state.previous_dt,
                  state.grid[0].z.row(0, 0)[0],
                  2 * force[1],
                  2 * force[2],
                  2 * force[0],
                  2 * force[1] - pressure_drag,
                  budget.kinetic_energy,
                  budget.dissipation,
                  budget.wall_power,
                  budget.outer_power,
                  0,
                  budget.momentum[1],
                  budget.momentum[2],
                  budget.outer_force[1],
                  static_cast<double>(summary.pressure_iterations),
                  static_cast<double>(summary.velocity_iterations),
                  static_cast<double>(summary.grid_passes),
                  summary.least_area,
                  summary.largest_wall_area,
                  summary.CFL};
  if (!history.rows.empty()) {
    const FluidRow& last = history.rows.back();
    row[defect_column] = last[defect_column] + row[kinetic_column] - last[kinetic_column] -
                         (row[t_column] - last[t_column]) * (power(row) + power(last)) / 2;
  }
  history.rows.push_back(row);
  std::vector<double> stations;
  for (int plane = 0; plane < planes; ++plane) {
    const Vector3 station = plane_force(fluid, traction, plane);
    stations.insert(stations.end(), {station[1], station[2], station[0]});
  }
  append(ranks::gather(stations), history.stations);
  for (std::size_t k = 0; k < probes.y.size(); ++k) {
    std::vector<double> found;
    for (int plane = 0; plane < planes; ++plane) {
      const std::optional<GridPoint> point =
          find_point(fluid.grid(), state.grid[0], plane, probes.y[k], probes.z[k]);
      const auto value = [&](const Field<double>& f) {
        return point ? point->value(f, plane) : std::numeric_limits<double>::quiet_NaN();
      };
      found.insert(found.end(),
                   {value(state.u[along_y]), value(state.u[along_z]),
                    state.u.size() > along_x ? value(state.u[along_x]) : 0.0, value(state.p)});
    }
    append(ranks::gather(found), history.probes);
  }
}

void write_history(const FluidHistory& history, const Span& span, const Settings& settings,
                   const std::filesystem::path& folder) {
  if (!ranks::is_leading()) return;
  const ProbeSettings& probes = settings.probes;
  std::vector<std::string> names = names_of(columns_of(history));
  const std::size_t count = probes.y.size();
  for (std::size_t k = 0; k < count; ++k)
    for (const char* value : {"v", "w", "u", "p"}) names.push_back(fmt::format("{}_{}", value, k));
  CsvText table(
      "history of the fluid, probes in the first plane; history.h5 says what each column is",
      names);
  const auto planes = static_cast<std::size_t>(span.planes());
  for (std::size_t r = 0; r < history.rows.size(); ++r) {
    std::vector<double> row = row_of(history, r);
    for (std::size_t k = 0; k < count; ++k) {
      const double* probe = history.probes.data() + (r * count + k) * planes * values_of_probe;
      row.insert(row.end(), probe, probe + values_of_probe);
    }
    table.row(row);
  }
  write_file(folder / "history.csv", table.text());

  hdf5::Writer file(folder / "history.h5");
  file.attributes({{"kind", history.flag.empty() ? "fluid_history" : "coupled_history"},
                   {"span", span.length()}});
  write_arrays(history, span.planes(), count, file);
  if (count > 0) {
    file.write("/probe_y", {count}, probes.y, {{"meaning", "in L"}});
    file.write("/probe_z", {count}, probes.z, {{"meaning", "in L"}});
  }
  file.finish();
  write_shapes(history.shapes, settings.output.contour_times, folder);
}

FluidHistory read_fluid_history(const hdf5::Reader& file, const HistoryInCheckpoint& expected) {
  FluidHistory history;
  history.shapes = read_shapes(file);
  if (!file.contains("/history")) return history;
  const std::size_t columns = fluid_columns + (expected.is_coupled ? coupled_columns : 0);
  const hdf5::Array rows = read_rows(file, columns, expected.t);
  const auto planes = static_cast<hsize_t>(expected.planes);
  for (std::size_t r = 0; r < rows.shape[0]; ++r) {
    const double* values = rows.values.data() + r * columns;
    std::copy_n(values, fluid_columns, history.rows.emplace_back().begin());
    if (columns > fluid_columns)
      std::copy_n(values + fluid_columns, coupled_columns, history.flag.emplace_back().begin());
  }
  const hdf5::Shape of_planes = {rows.shape[0], planes, values_of_station};
  if (expected.is_coupled) history.trailing_edge = file.read("/trailing_edge", of_planes).values;
  history.stations = file.read("/stations", of_planes).values;
  if (expected.probes > 0)
    history.probes =
        file.read("/probes", {rows.shape[0], expected.probes, planes, values_of_probe}).values;
  return history;
}

}  // namespace pennon::dns

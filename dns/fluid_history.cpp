#include "dns/fluid_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/atomic_file.hpp"
#include "common/csv.hpp"
#include "common/ranks.hpp"
#include "dns/grid_point.hpp"

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
      {"CFL", "largest Courant number of the step"},
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
                  summary.CFL};
  if (!history.rows.empty()) {
    const FluidRow& last = history.rows.back();
    row[defect_column] = last[defect_column] + row[kinetic_column] - last[kinetic_column] -
                         (row[t_column] - last[t_column]) * (power(row) + power(last)) / 2;
  }
  history.rows.push_back(row);
  std::vector<double> stations;
  for (int plane = 0; plane < planes; ++plane) {
    const Vector3 station = station_force(fluid, traction, plane);
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
      found.insert(found.end(), {value(state.u[0]), value(state.u[1]),
                                 state.u.size() > 2 ? value(state.u[2]) : 0.0, value(state.p)});
    }
    append(ranks::gather(found), history.probes);
  }
}

void write_history(const FluidHistory& history, int planes, std::size_t probes,
                   hdf5::Writer& file) {
  std::vector<double> values;
  for (const FluidRow& row : history.rows) values.insert(values.end(), row.begin(), row.end());
  const hsize_t rows = history.rows.size();
  file.write("/history", {rows, fluid_columns}, values, attributes_of(columns_of_fluid_history()));
  file.write("/stations", {rows, static_cast<hsize_t>(planes), values_of_station}, history.stations,
             {{"meaning", "drag, lift and side force of each plane, in rho_f V^2 L per span"}});
  if (probes == 0) return;
  file.write("/probes", {rows, probes, static_cast<hsize_t>(planes), values_of_probe},
             history.probes, {{"meaning", "v, w, u, p, in V and rho_f V^2"}});
}

void write_history(const FluidHistory& history, const Span& span, const ProbeSettings& probes,
                   const std::filesystem::path& folder) {
  if (!ranks::is_leading()) return;
  std::vector<std::string> names = names_of(columns_of_fluid_history());
  const std::size_t count = probes.y.size();
  for (std::size_t k = 0; k < count; ++k)
    for (const char* value : {"v", "w", "u", "p"}) names.push_back(fmt::format("{}_{}", value, k));
  CsvText table(
      "history of the fluid, probes in the first plane; history.h5 says what each column is",
      names);
  const auto planes = static_cast<std::size_t>(span.planes());
  for (std::size_t r = 0; r < history.rows.size(); ++r) {
    std::vector<double> row(history.rows[r].begin(), history.rows[r].end());
    for (std::size_t k = 0; k < count; ++k) {
      const double* probe = history.probes.data() + (r * count + k) * planes * values_of_probe;
      row.insert(row.end(), probe, probe + values_of_probe);
    }
    table.row(row);
  }
  write_file(folder / "history.csv", table.text());

  hdf5::Writer file(folder / "history.h5");
  file.attributes({{"kind", "fluid_history"}, {"span", span.length()}});
  write_history(history, span.planes(), count, file);
  if (count > 0) {
    file.write("/probe_y", {count}, probes.y, {{"meaning", "in L"}});
    file.write("/probe_z", {count}, probes.z, {{"meaning", "in L"}});
  }
  file.finish();
}

FluidHistory read_fluid_history(const hdf5::Reader& file) {
  FluidHistory history;
  const hdf5::Array rows = file.read("/history");
  for (std::size_t r = 0; r < rows.shape[0]; ++r) {
    FluidRow row;
    std::copy_n(rows.values.begin() + static_cast<std::ptrdiff_t>(r * fluid_columns), fluid_columns,
                row.begin());
    history.rows.push_back(row);
  }
  history.stations = file.read("/stations").values;
  if (file.contains("/probes")) history.probes = file.read("/probes").values;
  return history;
}

}  // namespace pennon::dns

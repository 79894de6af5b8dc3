#include "dns/flag_history.hpp"

#include <algorithm>

#include "common/atomic_file.hpp"
#include "common/csv.hpp"

namespace pennon::dns {
namespace {

hdf5::Attributes column_names() {
  hdf5::Attributes attributes;
  std::string names;
  for (const HistoryColumn& column : columns_of_history()) {
    if (!names.empty()) names += ',';
    names += column.name;
    attributes[column.name] = std::string(column.meaning);
  }
  attributes["columns"] = names;
  return attributes;
}

std::vector<double> flattened(const std::vector<HistoryRow>& rows) {
  std::vector<double> values;
  for (const HistoryRow& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

void write_rows(const FlagHistory& history, hdf5::Writer& file) {
  file.write("/history", {history.rows.size(), history_columns}, flattened(history.rows),
             column_names());
}

void write_shapes(const FlagHistory& history, std::size_t nodes, hdf5::Writer& file) {
  file.write("/shape_times", {history.shape_times.size()}, history.shape_times,
             {{"meaning", "t, in L/V"}});
  file.write("/shapes", {history.shape_times.size(), nodes, 3}, history.shapes,
             {{"meaning", "x, y, z of each node, in L"}});
}

}  // namespace

const std::array<HistoryColumn, history_columns>& columns_of_history() {
  static const std::array<HistoryColumn, history_columns> columns = {{
      {"t", "time, in L/V"},
      {"x", "x of the probe, in L"},
      {"y", "y of the probe, in L"},
      {"z", "z of the probe, in L"},
      {"kinetic", "kinetic energy, in rho_f V^2 L^3 (two dimensions: L^2, per unit span)"},
      {"bending", "bending energy, in the same unit"},
      {"stretch_2d", "energy of the chordwise strain, in the same unit"},
      {"stretch_3d", "what the span adds to the energy of stretch, in the same unit"},
      {"gravity", "gravitational energy, in the same unit"},
      {"dissipated", "by the damping since the start, in the same unit"},
      {"work", "of the loads since the start, in the same unit"},
      {"total",
       "all energies with the dissipated, less the work: constant but for the method's error"},
      {"least_strain", "of all segments"},
      {"greatest_strain", "of all segments"},
      {"iterations", "of Newton's method in the step"},
  }};
  return columns;
}

template <int dim>
HistoryRow history_row(const Flag<dim>& flag, const FlagLoads<dim>& loads, double t,
                       const NodeVectors<dim>& x, const NodeVectors<dim>& v, double dissipated,
                       double work, int probe, int iterations) {
  const FlagEnergies e = flag.energies(x, v, loads);
  const auto [least, greatest] = flag.stretch().strain_range(x);
  const double across = dim == 3 ? x(0, probe) : 0.0;
  return {t,
          across,
          x(dim - 2, probe),
          x(dim - 1, probe),
          e.kinetic,
          e.bending,
          e.stretch_2d,
          e.stretch_3d,
          e.gravity,
          dissipated,
          work,
          e.total() + dissipated - work,
          least,
          greatest,
          static_cast<double>(iterations)};
}

template HistoryRow history_row(const Flag<2>&, const FlagLoads<2>&, double, const NodeVectors<2>&,
                                const NodeVectors<2>&, double, double, int, int);
template HistoryRow history_row(const Flag<3>&, const FlagLoads<3>&, double, const NodeVectors<3>&,
                                const NodeVectors<3>&, double, double, int, int);

void write_history(const FlagHistory& history, const FlagMesh& mesh,
                   const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : columns_of_history()) names.emplace_back(column.name);
  CsvText table("history of the flag; history.h5 says what each column is", names);
  for (const HistoryRow& row : history.rows) table.row({row.begin(), row.end()});
  write_file(folder / "history.csv", table.text());

  hdf5::Writer rows(folder / "history.h5");
  rows.attributes({{"kind", "flag_history"}});
  write_rows(history, rows);
  rows.finish();

  if (history.shape_times.empty()) return;
  hdf5::Writer shapes(folder / "shapes.h5");
  shapes.attributes({{"kind", "flag_shapes"},
                     {"stations", std::int64_t(mesh.stations())},
                     {"chord_nodes", std::int64_t(mesh.chord_nodes())}});
  write_shapes(history, static_cast<std::size_t>(mesh.nodes()), shapes);
  shapes.finish();
}

void write_history(const FlagHistory& history, hdf5::Writer& file) {
  write_rows(history, file);
  const std::size_t nodes =
      history.shape_times.empty() ? 0 : history.shapes.size() / 3 / history.shape_times.size();
  if (nodes > 0) write_shapes(history, nodes, file);
}

FlagHistory read_history(const hdf5::Reader& file) {
  FlagHistory history;
  const hdf5::Array rows = file.read("/history");
  for (std::size_t r = 0; r < rows.shape[0]; ++r) {
    HistoryRow row;
    std::copy_n(rows.values.begin() + static_cast<std::ptrdiff_t>(r * history_columns),
                history_columns, row.begin());
    history.rows.push_back(row);
  }
  if (file.contains("/shapes")) {
    history.shape_times = file.read("/shape_times").values;
    history.shapes = file.read("/shapes").values;
  }
  return history;
}

}  // namespace pennon::dns

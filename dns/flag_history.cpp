#include "dns/flag_history.hpp"

#include <algorithm>

#include "common/atomic_file.hpp"
#include "common/csv.hpp"
#include "common/xdmf.hpp"

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

struct StrainName {
  const char* array;
  const char* meaning;
};
constexpr std::array<StrainName, 3> strain_names = {{{"e_1", "strain along the chord of each cell"},
                                                     {"e_2", "strain along the span of each cell"},
                                                     {"shear", "x_1.x_2 of each cell"}}};

// In two dimensions there is the strain along the chord alone.
std::size_t strains_of(const FlagShapes& shapes) {
  return shapes.strains[1].empty() ? 1 : 3;
}

void write_shapes(const FlagShapes& shapes, hdf5::Writer& file) {
  const std::size_t count = shapes.times.size();
  const std::size_t nodes = shapes.positions.size() / 3 / count;
  file.write("/shape_times", {count}, shapes.times, {{"meaning", "t, in L/V"}});
  file.write("/shapes", {count, nodes, 3}, shapes.positions,
             {{"meaning", "x, y, z of each node, in L"}});
  file.write("/velocities", {count, nodes, 3}, shapes.velocities,
             {{"meaning", "along x, y, z of each node, in V"}});
  for (std::size_t k = 0; k < strains_of(shapes); ++k)
    file.write(std::string("/") + strain_names[k].array, {count, shapes.strains[k].size() / count},
               shapes.strains[k], {{"meaning", strain_names[k].meaning}});
}

// What of shapes.h5 is drawn: all but the cells that close a periodic span.
void write_xdmf(const FlagShapes& shapes, const FlagMesh& mesh,
                const std::filesystem::path& folder) {
  const hsize_t count = shapes.times.size();
  const auto stations = static_cast<hsize_t>(mesh.stations());
  const auto chord_nodes = static_cast<hsize_t>(mesh.chord_nodes());
  const hsize_t nodes = stations * chord_nodes;
  const hsize_t cells = std::max<hsize_t>(stations - 1, 1) * (chord_nodes - 1);
  std::vector<xdmf::Grid> series;
  for (hsize_t s = 0; s < count; ++s) {
    const auto of_nodes = [&](const char* array) {
      return xdmf::row_of({"shapes.h5", array, {count, nodes, 3}, {}, {}}, s);
    };
    xdmf::Grid grid{shapes.times[s], {stations, chord_nodes}, of_nodes("/shapes"), {}};
    grid.attributes.push_back({"velocity", xdmf::Center::node, of_nodes("/velocities")});
    for (std::size_t k = 0; k < strains_of(shapes); ++k) {
      const std::string name = strain_names[k].array;
      xdmf::Block strain = xdmf::row_of(
          {"shapes.h5", "/" + name, {count, shapes.strains[k].size() / count}, {}, {}}, s);
      strain.count[1] = cells;
      grid.attributes.push_back({name, xdmf::Center::cell, std::move(strain)});
    }
    series.push_back(std::move(grid));
  }
  xdmf::write(folder / "shapes.xdmf", "flag", series);
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

template <int dim>
void add_shape(const Flag<dim>& flag, double t, const NodeVectors<dim>& x,
               const NodeVectors<dim>& v, FlagShapes& shapes) {
  const auto add = [](const NodeVectors<dim>& vectors, std::vector<double>& to) {
    for (const auto& vector : vectors.colwise()) {
      if constexpr (dim == 2) to.push_back(0);
      to.insert(to.end(), vector.begin(), vector.end());
    }
  };
  shapes.times.push_back(t);
  add(x, shapes.positions);
  add(v, shapes.velocities);
  const Eigen::Matrix3Xd strains = flag.stretch().strains(x);
  for (std::size_t k = 0; k < (dim == 2 ? 1 : 3); ++k) {
    const auto row = strains.row(static_cast<Eigen::Index>(k));
    shapes.strains[k].insert(shapes.strains[k].end(), row.begin(), row.end());
  }
}

template void add_shape(const Flag<2>&, double, const NodeVectors<2>&, const NodeVectors<2>&,
                        FlagShapes&);
template void add_shape(const Flag<3>&, double, const NodeVectors<3>&, const NodeVectors<3>&,
                        FlagShapes&);

void write_history(const FlagHistory& history, const FlagMesh& mesh,
                   const std::vector<double>& contour_times, const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const HistoryColumn& column : columns_of_history()) names.emplace_back(column.name);
  CsvText table("history of the flag; history.h5 says what each column is", names);
  for (const HistoryRow& row : history.rows) table.row({row.begin(), row.end()});
  write_file(folder / "history.csv", table.text());

  hdf5::Writer rows(folder / "history.h5");
  rows.attributes({{"kind", "flag_history"}});
  write_rows(history, rows);
  rows.finish();

  if (history.shapes.times.empty()) return;
  hdf5::Writer shapes(folder / "shapes.h5");
  shapes.attributes({{"kind", "flag_shapes"},
                     {"stations", std::int64_t(mesh.stations())},
                     {"chord_nodes", std::int64_t(mesh.chord_nodes())}});
  write_shapes(history.shapes, shapes);
  shapes.write("/contour_times", {contour_times.size()}, contour_times,
               {{"meaning", "of the shapes whose strain is drawn, in L/V"}});
  shapes.finish();
  write_xdmf(history.shapes, mesh, folder);
}

void write_history(const FlagHistory& history, hdf5::Writer& file) {
  write_rows(history, file);
  if (!history.shapes.times.empty()) write_shapes(history.shapes, file);
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
    FlagShapes& shapes = history.shapes;
    shapes.times = file.read("/shape_times").values;
    shapes.positions = file.read("/shapes").values;
    shapes.velocities = file.read("/velocities").values;
    for (std::size_t k = 0; k < strain_names.size(); ++k)
      if (const std::string array = std::string("/") + strain_names[k].array; file.contains(array))
        shapes.strains[k] = file.read(array).values;
  }
  return history;
}

}  // namespace pennon::dns

#include "dns/run/flag_history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/xdmf.hpp"

namespace pennon::dns {
namespace {

std::vector<double> flattened(const std::vector<HistoryRow>& rows) {
  std::vector<double> values;
  for (const HistoryRow& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

void write_rows(const FlagHistory& history, hdf5::Writer& file) {
  file.write("/history", {history.rows.size(), history_columns}, flattened(history.rows),
             attributes_of(columns_of_history()));
}

struct ShapeQuantity {
  const char* name;
  const char* meaning;
};
constexpr std::array<ShapeQuantity, 3> velocities = {
    {{"v_x", "velocity along x of each node, in V"},
     {"v_y", "velocity along y of each node, in V"},
     {"v_z", "velocity along z of each node, in V"}}};
constexpr std::array<ShapeQuantity, 3> strains = {{{"e_1", "strain along the chord of each cell"},
                                                   {"e_2", "strain along the span of each cell"},
                                                   {"shear", "x_1.x_2 of each cell"}}};

std::string array_name(const char* quantity, std::size_t shape) {
  return fmt::format("/{}/{:06}", quantity, shape);
}

constexpr const char* shapes_file = "shapes.h5";

hdf5::Shape cells_of(const FlagShapes& shapes) {
  return {std::max<hsize_t>(shapes.rows - 1, 1), shapes.columns - 1};
}

// Writes each shape as arrays of its own and says where they are, if `file` is that of the shapes.
std::vector<xdmf::Grid> write_arrays(const FlagShapes& shapes, hdf5::Writer& file) {
  file.write("/shape_times", {shapes.times.size()}, shapes.times, {{"meaning", "t, in L/V"}});
  const hdf5::Shape nodes = {shapes.rows, shapes.columns};
  const hdf5::Shape cells = cells_of(shapes);
  std::vector<xdmf::Grid> series;
  for (std::size_t s = 0; s < shapes.times.size(); ++s) {
    const auto write = [&](const ShapeQuantity& quantity, const hdf5::Shape& shape,
                           const std::vector<double>& values) {
      const std::string array = array_name(quantity.name, s);
      file.write(array, shape, values, {{"meaning", quantity.meaning}});
      return xdmf::Source{shapes_file, array, shape};
    };
    xdmf::Grid grid{shapes.times[s],
                    nodes,
                    write({"position", "x, y, z of each node, in L"},
                          {shapes.rows, shapes.columns, 3}, shapes.positions[s]),
                    {}};
    for (std::size_t k = 0; k < velocities.size(); ++k)
      grid.attributes.push_back({velocities[k].name, xdmf::Center::node,
                                 write(velocities[k], nodes, shapes.velocities[s][k])});
    for (std::size_t k = 0; k < strains.size(); ++k) {
      if (shapes.strains[s][k].empty()) continue;
      xdmf::Source strain = write(strains[k], cells, shapes.strains[s][k]);
      if (shapes.rows > 1)  // else the grid is a line
        grid.attributes.push_back({strains[k].name, xdmf::Center::cell, std::move(strain)});
    }
    series.push_back(std::move(grid));
  }
  return series;
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
  const FlagMesh& mesh = flag.mesh();
  const bool closes = dim == 3 && mesh.is_periodic();
  shapes.rows = static_cast<hsize_t>(mesh.stations()) + (closes ? 1 : 0);
  shapes.columns = static_cast<hsize_t>(mesh.chord_nodes());
  const auto nodes = static_cast<Eigen::Index>(shapes.rows * shapes.columns);
  const auto closed = [&](const NodeVectors<dim>& vectors, double period) {
    Eigen::Matrix3Xd all = Eigen::Matrix3Xd::Zero(3, nodes);
    all.bottomLeftCorner<dim, Eigen::Dynamic>(dim, vectors.cols()) = vectors;
    if (closes) {
      const auto columns = static_cast<Eigen::Index>(shapes.columns);
      all.rightCols(columns) = all.leftCols(columns);
      all.row(0).tail(columns).array() += period;
    }
    return all;
  };
  const auto rows_of = [](const Eigen::Matrix3Xd& all, Eigen::Index count) {
    std::array<std::vector<double>, 3> rows;
    for (Eigen::Index k = 0; k < count; ++k)
      rows[static_cast<std::size_t>(k)].assign(all.row(k).begin(), all.row(k).end());
    return rows;
  };
  shapes.times.push_back(t);
  const Eigen::Matrix3Xd positions = closed(x, mesh.span());
  shapes.positions.emplace_back(positions.data(), positions.data() + positions.size());
  shapes.velocities.push_back(rows_of(closed(v, 0), 3));
  shapes.strains.push_back(rows_of(flag.stretch().strains(x), dim == 2 ? 1 : 3));
}

template void add_shape(const Flag<2>&, double, const NodeVectors<2>&, const NodeVectors<2>&,
                        FlagShapes&);
template void add_shape(const Flag<3>&, double, const NodeVectors<3>&, const NodeVectors<3>&,
                        FlagShapes&);

void write_shapes(const FlagShapes& shapes, const std::vector<double>& contour_times,
                  const std::filesystem::path& folder) {
  if (shapes.times.empty()) return;
  hdf5::Writer file(folder / shapes_file);
  file.attributes({{"kind", "flag_shapes"}});
  const std::vector<xdmf::Grid> series = write_arrays(shapes, file);
  file.write("/contour_times", {contour_times.size()}, contour_times,
             {{"meaning", "of the shapes whose strain is drawn, in L/V"}});
  file.finish();
  xdmf::write(folder / "shapes.xdmf", "flag", series);
}

FlagShapes read_shapes(const hdf5::Reader& file) {
  FlagShapes shapes;
  if (!file.contains("/shape_times")) return shapes;
  shapes.times = file.list("/shape_times");
  const hdf5::Shape first = file.shape(array_name("position", 0), {hdf5::any, hdf5::any, 3});
  shapes.rows = first[0];
  shapes.columns = first[1];
  const hdf5::Shape nodes = {shapes.rows, shapes.columns}, cells = cells_of(shapes);
  for (std::size_t s = 0; s < shapes.times.size(); ++s) {
    shapes.positions.push_back(file.read(array_name("position", s), first).values);
    const auto read = [&](const std::array<ShapeQuantity, 3>& quantities,
                          const hdf5::Shape& expected) {
      std::array<std::vector<double>, 3> values;
      for (std::size_t k = 0; k < 3; ++k)
        if (const std::string array = array_name(quantities[k].name, s); file.contains(array))
          values[k] = file.read(array, expected).values;
      return values;
    };
    shapes.velocities.push_back(read(velocities, nodes));
    shapes.strains.push_back(read(strains, cells));
  }
  return shapes;
}

void write_history(const FlagHistory& history, const std::vector<double>& contour_times,
                   const std::filesystem::path& folder) {
  CsvText table("history of the flag; history.h5 says what each column is",
                names_of(columns_of_history()));
  for (const HistoryRow& row : history.rows) table.row({row.begin(), row.end()});
  write_file(folder / "history.csv", table.text());

  hdf5::Writer rows(folder / "history.h5");
  rows.attributes({{"kind", "flag_history"}});
  write_rows(history, rows);
  rows.finish();

  write_shapes(history.shapes, contour_times, folder);
}

hdf5::Array read_rows(const hdf5::Reader& file, std::size_t columns, double last) {
  hdf5::Array rows = file.read("/history", {hdf5::any, columns});
  double before = -std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < rows.shape[0]; ++r) {
    const double t = rows.values[r * columns];
    if (!(t > before && t <= last))
      file.fail(
          fmt::format("has t = {} in row {} of /history; it must lie above {} and not above "
                      "{}, the time of the checkpoint",
                      t, r, before, last));
    before = t;
  }
  return rows;
}

FlagHistory read_history(const hdf5::Reader& file, double t) {
  FlagHistory history;
  const hdf5::Array rows = read_rows(file, history_columns, t);
  for (std::size_t r = 0; r < rows.shape[0]; ++r) {
    HistoryRow row;
    std::copy_n(rows.values.begin() + static_cast<std::ptrdiff_t>(r * history_columns),
                history_columns, row.begin());
    history.rows.push_back(row);
  }
  history.shapes = read_shapes(file);
  return history;
}

}  // namespace pennon::dns

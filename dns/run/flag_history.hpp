/// What a run of the flag keeps: a row of numbers at intervals, shapes at intervals.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "common/io/hdf5.hpp"
#include "dns/flag/flag.hpp"
#include "dns/run/history_columns.hpp"

namespace pennon::dns {

inline constexpr std::size_t history_columns = 15;
const std::array<HistoryColumn, history_columns>& columns_of_history();
using HistoryRow = std::array<double, history_columns>;

/// The row of a state; `iterations` of the step that led to it.
template <int dim>
HistoryRow history_row(const Flag<dim>&, const FlagLoads<dim>&, double t, const NodeVectors<dim>& x,
                       const NodeVectors<dim>& v, double dissipated, double work, int probe,
                       int iterations);

/// The flag at some times as a grid of nodes, `rows` along the span by `columns` along the chord: a
/// periodic span is closed by its first station once more, a period further.
struct FlagShapes {
  hsize_t rows = 0, columns = 0;
  std::vector<double> times;
  std::vector<std::vector<double>> positions;  ///< for each time: x, y, z of each node
  /// For each time: the velocity's components at the nodes.
  std::vector<std::array<std::vector<double>, 3>> velocities;
  /// For each time: e_1, e_2 and shear of the cells; in two dimensions e_1 of the segments. See
  /// Stretch.
  std::vector<std::array<std::vector<double>, 3>> strains;
};
template <int dim>
void add_shape(const Flag<dim>&, double t, const NodeVectors<dim>& x, const NodeVectors<dim>& v,
               FlagShapes&);

/// Writes shapes.h5 (kind = "flag_shapes") with shapes.xdmf, by which ParaView draws it; nothing
/// without shapes. `contour_times`: of the shapes whose strain will be drawn, kept in shapes.h5.
/// Throws FileError.
void write_shapes(const FlagShapes&, const std::vector<double>& contour_times,
                  const std::filesystem::path& folder);
/// The shapes in a checkpoint of an earlier version. Throws InputError where they are of different
/// sizes.
FlagShapes read_shapes(const hdf5::Reader&);

struct FlagHistory {
  std::vector<HistoryRow> rows;
  FlagShapes shapes;
};

/// Writes history.csv and history.h5 (kind = "flag_history"), and the shapes. Throws FileError.
void write_history(const FlagHistory&, const std::vector<double>& contour_times,
                   const std::filesystem::path& folder);

/// The history in a checkpoint of an earlier version. Throws InputError where a row is later than
/// t, the time of the checkpoint.
FlagHistory read_history(const hdf5::Reader&, double t);

/// The rows of /history with so many columns, of which the first is t. Throws InputError where the
/// file has others, or t does not increase up to `last`.
hdf5::Array read_rows(const hdf5::Reader&, std::size_t columns, double last);

}  // namespace pennon::dns

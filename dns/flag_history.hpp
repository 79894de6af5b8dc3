/// What a run of the flag keeps: a row of numbers at intervals, shapes at intervals.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "common/hdf5.hpp"
#include "dns/flag.hpp"

namespace pennon::dns {

struct HistoryColumn {
  const char* name;
  const char* meaning;
};

inline constexpr std::size_t history_columns = 15;
const std::array<HistoryColumn, history_columns>& columns_of_history();
using HistoryRow = std::array<double, history_columns>;

/// The row of a state; `iterations` of the step that led to it.
template <int dim>
HistoryRow history_row(const Flag<dim>&, const FlagLoads<dim>&, double t, const NodeVectors<dim>& x,
                       const NodeVectors<dim>& v, double dissipated, double work, int probe,
                       int iterations);

/// Where all nodes are at some times, how fast they move, and how the flag is strained.
struct FlagShapes {
  std::vector<double> times;
  std::vector<double> positions;               ///< [shape][node][3]: x, y, z
  std::vector<double> velocities;              ///< [shape][node][3]
  std::array<std::vector<double>, 3> strains;  ///< e_1, e_2, shear: [shape][element]; see Stretch
};
template <int dim>
void add_shape(const Flag<dim>&, double t, const NodeVectors<dim>& x, const NodeVectors<dim>& v,
               FlagShapes&);

struct FlagHistory {
  std::vector<HistoryRow> rows;
  FlagShapes shapes;
};

/// Writes history.csv and history.h5 (kind = "flag_history"), and if there are shapes shapes.h5
/// (kind = "flag_shapes") with shapes.xdmf, by which ParaView draws it. `contour_times`: of the
/// shapes whose strain will be drawn, kept in shapes.h5. Throws FileError.
void write_history(const FlagHistory&, const FlagMesh&, const std::vector<double>& contour_times,
                   const std::filesystem::path& folder);

/// The same as part of a checkpoint.
void write_history(const FlagHistory&, hdf5::Writer&);
FlagHistory read_history(const hdf5::Reader&);

}  // namespace pennon::dns

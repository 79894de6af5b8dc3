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

/// Rows, and shapes as (x, y, z) of all nodes, with their times.
struct FlagHistory {
  std::vector<HistoryRow> rows;
  std::vector<double> shape_times;
  std::vector<double> shapes;  ///< [shape][node][3]
};

/// Writes history.csv and history.h5 (kind = "flag_history"), and shapes.h5 (kind = "flag_shapes")
/// if there are shapes. Throws FileError.
void write_history(const FlagHistory&, const FlagMesh&, const std::filesystem::path& folder);

/// The same as part of a checkpoint.
void write_history(const FlagHistory&, hdf5::Writer&);
FlagHistory read_history(const hdf5::Reader&);

}  // namespace pennon::dns

/// What a run of the flow keeps: rows of numbers, the forces on each plane, the probes, and of a
/// flag that the flow moves its energies, its trailing edge and its shapes.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "common/io/hdf5.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/fluid/forces.hpp"
#include "dns/run/flag_history.hpp"
#include "dns/run/history_columns.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

inline constexpr std::size_t fluid_columns = 21, coupled_columns = 12;
const std::array<HistoryColumn, fluid_columns>& columns_of_fluid_history();
using FluidRow = std::array<double, fluid_columns>;
using CoupledRow = std::array<double, coupled_columns>;

struct FluidHistory {
  std::vector<FluidRow> rows;
  std::vector<double> stations;  ///< [row][station]: drag, lift, side force per unit span
  std::vector<double> probes;    ///< [row][probe][plane]: v, w, u, p

  std::vector<CoupledRow> flag;       ///< for each row; none where the flag moves as prescribed
  std::vector<double> trailing_edge;  ///< [row][station]: x, y, z
  FlagShapes shapes;
};

/// The numbers of the flag in a coupled run, beside those of the fluid.
const std::array<HistoryColumn, coupled_columns>& columns_of_coupled_flag();

/// Adds a row for a state; stations and probes on the leading rank alone. Every rank calls. Probes
/// in the order of the settings; one outside the grid is NaN.
void add_row(const Fluid&, const FluidState&, const FluidStepSummary&, const ProbeSettings&,
             FluidHistory&);

/// Writes history.csv and history.h5 (kind = "fluid_history", with a flag that the flow moves
/// "coupled_history"), and the shapes. Throws FileError.
void write_history(const FluidHistory&, const Span&, const Settings&,
                   const std::filesystem::path& folder);

/// What the history of a checkpoint must fit.
struct HistoryInCheckpoint {
  double t;  ///< of the checkpoint
  int planes;
  std::size_t probes;
  bool is_coupled;
};
/// The history in a checkpoint of an earlier version; without rows where the run was stopped before
/// the first one. Throws InputError where it does not fit.
FluidHistory read_fluid_history(const hdf5::Reader&, const HistoryInCheckpoint&);

}  // namespace pennon::dns

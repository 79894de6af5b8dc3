/// What a run of the fluid keeps: rows of numbers, the forces on each plane, and the probes.
#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "common/hdf5.hpp"
#include "dns/fluid.hpp"
#include "dns/fluid_forces.hpp"
#include "dns/history_columns.hpp"
#include "dns/settings.hpp"

namespace pennon::dns {

inline constexpr std::size_t fluid_columns = 20;
const std::array<HistoryColumn, fluid_columns>& columns_of_fluid_history();
using FluidRow = std::array<double, fluid_columns>;

struct FluidHistory {
  std::vector<FluidRow> rows;
  std::vector<double> stations;  ///< [row][plane]: drag, lift, side force per span
  std::vector<double> probes;    ///< [row][probe][plane]: v, w, u, p
};

/// Adds a row for a state; stations and probes on the leading rank alone. Every rank calls. Probes
/// in the order of the settings; one outside the grid is NaN.
void add_row(const Fluid&, const FluidState&, const FluidStepSummary&, const ProbeSettings&,
             FluidHistory&);

/// Writes history.csv and history.h5 (kind = "fluid_history"). Throws FileError.
void write_history(const FluidHistory&, const Span&, const ProbeSettings&,
                   const std::filesystem::path& folder);

/// The same as part of a checkpoint.
void write_history(const FluidHistory&, int planes, std::size_t probes, hdf5::Writer&);
FluidHistory read_fluid_history(const hdf5::Reader&);

}  // namespace pennon::dns

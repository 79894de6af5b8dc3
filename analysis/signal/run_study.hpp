/// What a coupled run says, all of it: the work of `pennon analyze`.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "analysis/signal/energy_budget.hpp"
#include "analysis/signal/flapping_phases.hpp"
#include "analysis/signal/limit_cycle.hpp"
#include "analysis/signal/linear_phase.hpp"
#include "analysis/signal/run_context.hpp"
#include "analysis/signal/run_history.hpp"
#include "analysis/signal/settings.hpp"
#include "analysis/signal/spanwise_amplitudes.hpp"
#include "analysis/signal/travelling_wave.hpp"
#include "common/io/output_folder.hpp"

namespace pennon::analysis {

struct RunAnalysis {
  RunHistory run;
  std::vector<Complexes> components;  ///< zeta_n of the trailing edge
  LinearPhase linear;
  LimitCycleResult limit_cycle;
  Angles angles;
  Phases phases;
  EnergyBudget energy;

  /// Why a number is not there, in sentences.
  std::vector<std::string> notes() const;
};

/// Throws InputError as read_run_history(), and where the window
/// of the settings does not lie in the run.
RunAnalysis analyze_run(const std::filesystem::path& folder, const Settings&, const RunContext&);

/// The object of the key "analyze".
nlohmann::ordered_json to_json(const RunAnalysis&);

/// The same for a reader, without the notes.
std::string text_of(const RunAnalysis&);

/// Writes spanwise_amplitudes.csv, limit_cycle.csv and energy.csv. Throws FileError.
void write_tables(const RunAnalysis&, const OutputFolder&);

}  // namespace pennon::analysis

/// What a coupled run says, all of it: the work of `pennon analyze`.
#pragma once

#include <filesystem>
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

/// Throws InputError as read_run_history(), and where the window of the settings does not lie in
/// the run.
RunAnalysis analyze_run(const std::filesystem::path& folder, const Settings&, const RunContext&);

}  // namespace pennon::analysis

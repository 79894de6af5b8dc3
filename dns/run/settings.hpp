/// What a case asks of the direct simulation: the table [dns], and those below it that stand where
/// their concept does.
#pragma once

#include <cstdint>
#include <optional>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/coupling/settings.hpp"
#include "dns/flag/settings.hpp"
#include "dns/run/convergence_settings.hpp"
#include "dns/run/flag_loads.hpp"
#include "dns/run/fluid_settings.hpp"
#include "dns/run/initial_settings.hpp"
#include "dns/run/motion_settings.hpp"
#include "dns/run/output_settings.hpp"

namespace pennon::dns {

struct Settings {
  bool is_given = false;
  double dt = 1e-3;
  double t_end = 1;
  std::int64_t n_x = 60;
  FluidSettings fluid;
  MotionSettings motion;
  ProbeSettings probes;
  CouplingSettings coupling;
  FlagSettings flag;
  LoadSettings loads;
  InitialSettings initial;
  OutputSettings output;
  ConvergenceSettings convergence;
};

/// All tables of the simulation.
void declare(Schema&, Settings&);

/// Adds the faults between keys, of every table. `is_asked_for`: whether the simulation is to run
/// even if the case has no [dns].
void check(const Settings&, const FlagParameters&, bool has_flow, bool is_asked_for, Faults&);

/// The normal mode of the family of [modes.normal] that a run needs.
struct NormalModeUse {
  const char* table;  ///< whose keys n and m say which
  std::int64_t n, m;
};
/// That of the prescribed motion or of the start; none where there is no such.
std::optional<NormalModeUse> normal_mode_of(const Settings&, bool has_flow);

}  // namespace pennon::dns

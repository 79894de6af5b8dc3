/// A flag by itself, run as a case asks: to its equilibrium, or through time with history, shapes
/// and checkpoints.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/case/parameters.hpp"
#include "common/io/output_folder.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/run/flag_history.hpp"
#include "dns/run/settings.hpp"
#include "dns/run/time_loop.hpp"

namespace pennon::dns {

struct FlagRunResult {
  std::string status;  ///< "done" or "equilibrium"
  LoopSummary loop;    ///< of an equilibrium empty
  std::int64_t halved_steps = 0;
  std::int64_t nodes = 0;
  double iterations_mean = 0;
  int iterations_max = 0;
  double wall_seconds = 0;
  std::vector<HistoryRow> rows;  ///< of the history, at least one
};

/// Starts from z = zeta(x, y), or straight without it. Computes and writes history.h5, history.csv,
/// shapes.h5, shapes.xdmf and checkpoint.h5 to the folder. From a checkpoint it goes on to the
/// case's t_end; the result is bit-identical to an uninterrupted run that wrote a checkpoint at the
/// same time. Settings as check() accepts them. Throws SolverError (the last checkpoint's name in
/// it), InputError (a checkpoint of another flag), FileError, Interrupted.
FlagRunResult run_flag(const Settings&, const FlagParameters&, const std::optional<ShapeFunction>&,
                       const Beginning&, const OutputFolder&, bool shows_progress);

}  // namespace pennon::dns

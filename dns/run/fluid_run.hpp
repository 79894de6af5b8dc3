/// The flow about a flag, run as a case asks: a flag that is held or moves as prescribed, or one
/// that the flow moves; through time, with history, fields and checkpoints.
#pragma once

#include <cstdint>
#include <optional>

#include "common/case/parameters.hpp"
#include "common/io/output_folder.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/run/fluid_history.hpp"
#include "dns/run/settings.hpp"
#include "dns/run/time_loop.hpp"

namespace pennon::dns {

struct FluidRunResult {
  LoopSummary loop;
  std::int64_t cells = 0;
  double pressure_iterations_mean = 0;
  int pressure_iterations_max = 0;
  double least_area = 1;  ///< over the whole run, as the next
  double largest_wall_area = 1;
  double wall_seconds = 0;
  FluidRow last{};
  bool is_coupled = false;  ///< whether the flow moves the flag
  double passes_mean = 0;   ///< of the coupling
  int passes_max = 0;
  std::optional<CoupledRow> last_of_flag;  ///< where the flow moves it
};

/// Computes and writes history.h5, history.csv, shapes.h5, fields_*.h5 with fields.xdmf, and
/// checkpoint.h5. `shape`: the mode of a prescribed motion, or the displacement with which a flag
/// that the flow moves starts.
/// From a checkpoint it goes on to the case's t_end; the result is bit-identical to
/// an uninterrupted run. Settings as check() accepts them. Throws SolverError (the last
/// checkpoint's name in it), InputError (a checkpoint of another grid), FileError, Interrupted.
FluidRunResult run_fluid(const Settings&, const FlagParameters&, const FlowParameters&,
                         const std::optional<ShapeFunction>& shape, const Beginning&,
                         const OutputFolder&, bool shows_progress);

}  // namespace pennon::dns

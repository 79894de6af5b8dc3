/// The program pennon-global, which stands beside pennon, as a function.
#pragma once

#include "common/io/output_folder.hpp"
#include "modes/global/study/settings.hpp"
#include "modes/global/study/wire.hpp"

namespace pennon::app {

/// Writes global_problem.toml into the folder, has pennon-global solve it, and returns what it left
/// in global_modes.json. Throws what it ended with: InputError, SolverError, Interrupted; FileError
/// where it cannot be started. `shows_progress`: says how far a neutral curve or a map has come.
modes::global::Findings solve_global_modes(const modes::global::Problem&, const OutputFolder&,
                                           bool shows_progress);

/// Throws InputError where mpiexec started pennon itself: pennon-global has ranks of its own.
void expect_one_rank_for_global_modes();

}  // namespace pennon::app

/// Figures of a coupled run in the manner of the paper's figures 6 to 9 and 14 to 17.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "analysis/drawing/figure.hpp"
#include "analysis/signal/run_study.hpp"

namespace pennon::analysis {

/// z of the trailing edge at its antinode over time (figures 6 and 14), with the envelope of the
/// fitted growth.
Figure figure_of_trailing_edge(const RunAnalysis&);

/// |zeta| of the leading component on a logarithmic axis, with the fitted growth in its window.
/// Needs a fit.
Figure figure_of_growth(const RunAnalysis&);

/// |zeta_n| for n = 0 to 3 (figures 8 and 16). Needs a span.
Figure figure_of_spanwise_amplitudes(const RunAnalysis&);

/// The trailing edge along the span at successive times: each profile stands at its time, and z is
/// drawn along the axis of time (figures 7 and 15). Needs a span.
Figure figure_of_waterfall(const RunAnalysis&);

/// z of the trailing edge over time and span, coloured. Needs a span.
Figure figure_of_space_and_time(const RunAnalysis&);

/// Drag and lift coefficients (figures 9a, 9b and 17).
Figure figure_of_forces(const RunAnalysis&);

/// The flag's energies (figures 9c and 17).
Figure figure_of_flag_energy(const RunAnalysis&);

/// The energy of flag and fluid together, the energies received and dissipated, and the defect
/// (energy_budget.hpp).
Figure figure_of_energy_budget(const RunAnalysis&);

/// Draws all that the run allows into the folder and returns the names of the pictures.
std::vector<std::filesystem::path> draw_run(const RunAnalysis&,
                                            const std::filesystem::path& folder);

}  // namespace pennon::analysis

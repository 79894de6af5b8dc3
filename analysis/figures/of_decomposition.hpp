/// Figures of a modal decomposition, from the file that `pennon decompose` wrote
/// (analysis/decomposition/study.hpp).
#pragma once

#include <vector>

#include "analysis/figures/of_global_modes.hpp"

namespace pennon::analysis {

/// The energies of proper orthogonal modes; the growth rates and frequencies of dynamic modes with
/// their errors; the spectra of spectral modes with the interval of the first; the amplitudes of
/// waves.
Figure figure_of_decomposition(const hdf5::Reader&);

/// The coefficients over time, and the first modes where they lie along a chord or on a flag.
std::vector<NamedFigure> figures_of_modes(const hdf5::Reader&);

}  // namespace pennon::analysis

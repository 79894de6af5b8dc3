/// Figures of a simulated flag, from the files that dns/ wrote.
#pragma once

#include "analysis/figure.hpp"
#include "common/hdf5.hpp"

namespace pennon::analysis {

/// The energies over time (figure 24b of the paper).
Figure figure_of_flag_history(const hdf5::Reader&);

/// The chord of the first spanwise station in the (y, z) plane at the kept times (figure 24a).
Figure figure_of_flag_shapes(const hdf5::Reader&);

/// The error of a deflection by the spacing of the nodes (figures 21b and 23b), or of a frequency
/// by the time step (figure 22b).
Figure figure_of_flag_convergence(const hdf5::Reader&);

}  // namespace pennon::analysis

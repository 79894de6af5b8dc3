/// Figures of the flag's modes, from the files that modes/ wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// The chordwise shapes of the first normal modes.
Figure figure_of_normal_modes(const hdf5::Reader&);

}  // namespace pennon::analysis

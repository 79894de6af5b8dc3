/// Figures of a simulated flow, from the files that dns/ wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// Drag and lift over time.
Figure figure_of_fluid_history(const hdf5::Reader&);

/// z of the trailing edge of a coupled run over time, at its first station; with a span also at
/// stations a quarter of the span apart.
Figure figure_of_trailing_edge(const hdf5::Reader&);

/// The vorticity omega_x about the flag and in its wake, in the first plane.
Figure figure_of_fluid_fields(const hdf5::Reader&);

}  // namespace pennon::analysis

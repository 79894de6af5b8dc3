/// Figures of a simulated flag, from the files that dns/ wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "analysis/drawing/surface_picture.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// The energies over time (figure 24b of the paper).
Figure figure_of_flag_history(const hdf5::Reader&);

/// The chord of the first spanwise station in the (y, z) plane at the kept times.
Figure figure_of_flag_shapes(const hdf5::Reader&);

/// The flag in space with its strain along the chord, at the times the file asks for (figure 24a).
/// Only for a flag with a span.
SurfacePicture picture_of_strain(const hdf5::Reader&);

/// The error of a deflection by the spacing of the nodes (figures 21b and 23b), or of a frequency
/// by the time step (figure 22b).
Figure figure_of_flag_convergence(const hdf5::Reader&);

}  // namespace pennon::analysis

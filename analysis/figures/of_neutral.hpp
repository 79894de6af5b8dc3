/// The neutral curve of the global modes, from the file that `pennon modes` wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// Shows mu_cr over the parameter, the other neutral modes that were followed, the local theory for
/// each added mass, and known outcomes as marks.
Figure figure_of_neutral_curve(const hdf5::Reader&);

}  // namespace pennon::analysis

/// The neutral curve of the global modes, from the file that `pennon modes` wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// mu_cr over the parameter, the other neutral modes that were followed, the local theory for each
/// added mass and the marks of known outcomes.
Figure figure_of_neutral_curve(const hdf5::Reader&);

}  // namespace pennon::analysis

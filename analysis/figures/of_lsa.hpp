/// Figures of the local stability analysis, from the files it wrote.
#pragma once

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// Lines of a quantity, one for each member of the family (figures 3 and 4 of the paper).
Figure figure_of_curve(const hdf5::Reader&);

/// A field over two parameters with the neutral curve and the marks of known outcomes (figure 5),
/// of the local theory or of global modes.
Figure figure_of_map(const hdf5::Reader&);

/// mu_cr over k_y for each span of a table, its mass ratios, and the k_y that reproduce it.
Figure figure_of_verdicts(const hdf5::Reader&);

}  // namespace pennon::analysis

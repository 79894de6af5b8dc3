/// Figures of global modes, from the file that modes/global wrote
/// (modes/global/study/fields_file.hpp).
#pragma once

#include <string>
#include <vector>

#include "analysis/drawing/figure.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {

/// Growth rate against angular frequency; growing modes filled.
Figure figure_of_spectrum(const hdf5::Reader&);

struct NamedFigure {
  std::string name;
  Figure figure;
};

/// Of the first modes: mode_1_shape, the flag at each of shape_phases and the envelope
/// of its motion; mode_1_vorticity, the real part at fixed points about flag and wake; where there
/// are adjoints mode_1_wavemaker, and mode_1_flag_wavemaker along the flag.
std::vector<NamedFigure> figures_of_global_modes(const hdf5::Reader&);

}  // namespace pennon::analysis

/// Global modes on disk: HDF5, with an XDMF beside it that ParaView opens.
///
///   /points, /y, /tension           corners of the grid at rest; nodes of the flag, tension there
///   /flag                           where its nodes are in the steady flow
///   /growth, /omega, /residual      of the modes, in V/L
///   /base/v, w, p, omega_x          the steady flow at the cells
///   /mode_1/v_real, v_imag, ...     of the first mode, at points that move with the grid
///   /mode_1/fixed_v_real, ...       at fixed points
///   /mode_1/displacement_y_real ... of the grid's corners
///   /mode_1/zeta_real, zeta_imag    at the nodes of the flag
///   /mode_1/shapes                  Re [zeta exp(i phase)] at each of shape_phases
///   /mode_1/adjoint_v_real, ...     and wavemaker, flag_wavemaker, where there are adjoints
///
/// and u where there is a velocity along x. Cells and corners run [rho][theta] around the whole
/// flag, from the trailing edge over the upper side. In the XDMF the modes follow each other in
/// time, mode 1 at t = 1.
#pragma once

#include <filesystem>

#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// Writes FOLDER/global_modes.h5 and global_modes.xdmf, and where there are adjoints
/// global_flag_feedback.csv, the FlagFeedback along the chord; each whole or not at all. Throws
/// FileError.
void write_fields(const Result&, const std::filesystem::path& folder);

}  // namespace pennon::modes::global

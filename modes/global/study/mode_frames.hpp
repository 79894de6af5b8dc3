/// Global modes as animations over their period: HDF5 with XDMF files that ParaView opens.
///
/// Frame k of n is the steady flow and a times Re [q exp(i (k_x x + 2 pi k/n))], q the mode at
/// points that move with the grid, a such that the node of the flag that moves most moves by 0.1 L.
/// Growth is left out, so that the last frame goes on with the first. The grid is a volume, because
/// readers of XDMF take vectors there: one wave along the span, or one cell of 0.1 L in two
/// dimensions.
///
///   /frame_1/points                x, y, z of the grid's corners, moved by the mode
///   /frame_1/velocity, p, omega_x  at the cells, of flow and mode together
///   /frame_1/mode_velocity         of the mode by itself, for the displacement 1
///   /frame_1/flag                  x, y, z of the flag's nodes
///
/// Planes along x, then [rho][theta] as in fields_file.hpp.
#pragma once

#include <filesystem>

#include "modes/global/study/study.hpp"

namespace pennon::modes::global {

/// Writes FOLDER/global_mode_1.h5, global_mode_1.xdmf and global_mode_1_flag.xdmf for the first
/// mode of flag or wake, and so on; none without frames. Each whole or not at all. Throws
/// FileError.
void write_frames(const Result&, int frames, const std::filesystem::path& folder);

}  // namespace pennon::modes::global

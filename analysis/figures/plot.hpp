/// Pictures of pennon's output files: what `pennon plot` does, and every command after its work.
///
/// A file says what it holds in its attribute `kind`: lsa_curve, lsa_map, lsa_verdicts,
/// normal_modes, global_modes, global_neutral, global_map, flag_history, flag_shapes,
/// flag_convergence, fluid_history, coupled_history, fluid_fields, decomposition.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "analysis/drawing/surface_picture.hpp"
#include "analysis/figures/of_global_modes.hpp"

namespace pennon::analysis {

/// What is drawn of a file, read and checked.
struct Pictures {
  std::vector<NamedFigure> figures;  ///< the first has no name: it is the file's own
  std::optional<SurfacePicture> strain;
};
/// Whether a file is a checkpoint or the frames of a mode, which have no picture. Throws InputError
/// where it cannot be read.
bool has_no_picture(const std::filesystem::path& file);

/// Throws InputError where the file is none of pennon's, or damaged.
Pictures pictures_of(const std::filesystem::path& file);

/// Draws the picture of an output file beside it, map.png and map.svg for map.h5, and returns the
/// names of the pictures. Some files have more pictures: the shapes of a flag with a span also
/// shapes_strain.png, a coupled run also history_trailing_edge, global modes also those of
/// figures_of_global_modes(). Throws InputError where the file is none of pennon's, and FileError
/// as draw() does.
std::vector<std::filesystem::path> plot(const std::filesystem::path& file);

}  // namespace pennon::analysis

/// Pictures of pennon's output files: what `pennon plot` does, and every command after its work.
///
/// A file says what it holds in its attribute `kind`: lsa_curve, lsa_map, lsa_verdicts,
/// normal_modes, global_modes, global_neutral, global_map, flag_history, flag_shapes,
/// flag_convergence, fluid_history, coupled_history, fluid_fields.
#pragma once

#include <filesystem>
#include <vector>

namespace pennon::analysis {

/// Draws the picture of an output file beside it (map.h5: map.png and map.svg; of shapes of a flag
/// with a span shapes_strain.png besides, of a coupled run history_trailing_edge, of
/// global modes those of figures_of_global_modes()) and returns the
/// names of the pictures. Throws InputError where the file is none of pennon's, FileError as
/// draw().
std::vector<std::filesystem::path> plot(const std::filesystem::path& file);

}  // namespace pennon::analysis

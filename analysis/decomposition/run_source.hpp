/// Snapshots of a run of `pennon dns`: what lies in its folder.
///
/// The flag: z of its nodes, from shapes.h5. The weights are the nodes' pieces of the flag times
/// mu: lengths along the chord of the first shape, scaled to the chord's length 1, times the share
/// of the span. So <z, z> is the squared displacement of the flag's mass.
///
/// The fluid: its velocity at the cells, from fields_*.h5; the weights are the volumes of the cells
/// at the time, since the grid moves. So <u, u> is twice the kinetic energy. A value belongs to a
/// cell of the grid and not to a place.
#pragma once

#include <filesystem>
#include <memory>

#include "analysis/decomposition/snapshots.hpp"
#include "analysis/decomposition/times.hpp"

namespace pennon::decomposition {

/// Throws InputError where the folder has no shapes, or they do not fit together.
std::unique_ptr<Snapshots> open_run_flag(const std::filesystem::path& folder, double mu,
                                         const Window&);

/// Throws InputError where the folder has no fields, or they do not fit together.
std::unique_ptr<Snapshots> open_run_fluid(const std::filesystem::path& folder, const Window&);

}  // namespace pennon::decomposition

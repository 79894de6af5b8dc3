/// Global modes as `pennon modes` left them in global_modes.h5.
#pragma once

#include <filesystem>

#include "common/case/parameters.hpp"
#include "dns/coupling/flow_mode.hpp"
#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// The mode of that rank, 1 the first in the file, for a simulation of this fluid and flag. Without
/// a cross-flow a mode without waves along the span serves a simulation with one. Throws InputError
/// where the file is none, lacks the mode, or was made for another grid, flag or stream, or for a
/// wave that does not fit the span.
FlowMode read_flow_mode(const std::filesystem::path& file, int rank, const Fluid&,
                        const FlagParameters&);

}  // namespace pennon::dns

/// Global modes as `pennon modes` left them in global_modes.h5.
#pragma once

#include <filesystem>

#include "common/case/parameters.hpp"
#include "dns/coupling/flow_mode.hpp"
#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

/// Reads a mode for a simulation of this fluid and flag; `number` is 1 for the first in the file.
/// Without a cross-flow, a mode that does not vary along the span can be read for a simulation with
/// a span, too: its velocity along x is 0. Throws InputError where the file does not hold global
/// modes or not this one, or where it was made for another grid, flag or stream, or for a wave that
/// does not fit the span.
FlowMode read_flow_mode(const std::filesystem::path& file, int number, const Fluid&,
                        const FlagParameters&);

/// Whether the file holds global modes, this one among them; throws InputError where it does not.
void expect_flow_mode(const std::filesystem::path& file, int number);

}  // namespace pennon::dns

/// What a simulation would refuse once it starts, found before it does and by --check.
#pragma once

#include <optional>

#include "common/case/parameters.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

/// Builds the grid and the flag's shape at the start, looks into the file of global modes, and sets
/// the memory that the fields take beside what the machine has free. `zeta`: of the initial
/// displacement. Throws InputError about the key that does not serve.
void expect_start(const Settings&, const FlagParameters&, bool has_flow,
                  const std::optional<ShapeFunction>& zeta);

/// Bytes that a run takes on so many cells, of all ranks together: 910 a cell, as the peak memory
/// grows between 200 x 400 and 400 x 800 cells of a coupled run; it is somewhat more with a span.
double memory_of_fluid(double cells);

}  // namespace pennon::dns

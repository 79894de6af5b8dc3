/// Where a flag starts.
#pragma once

#include <optional>

#include "dns/flag/mesh.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/flag/step.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

/// The mode of a plate, or z = zeta(x, y) with every chordwise segment at its length, or straight
/// at an angle; in L. A periodic flag that varies along its span is longer than its period: the
/// nodes of each chordwise rank share that strain equally, by their x. Throws InputError where zeta
/// is steeper than the flag is long.
template <int dim>
NodeVectors<dim> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>& zeta,
                               const FlagMesh&);

}  // namespace pennon::dns

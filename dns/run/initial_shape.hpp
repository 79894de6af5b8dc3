/// The shape with which a simulation of a flag starts.
#pragma once

#include <optional>

#include "dns/flag/mesh.hpp"
#include "dns/flag/shape_function.hpp"
#include "dns/flag/step.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

/// The positions of the nodes, dim x nodes, in L. The flag has one of three shapes: the mode of a
/// plate (InitialSettings::plate_mode), z = zeta(x, y), or straight at an angle. With zeta each
/// chordwise segment keeps its length at rest. A periodic flag that varies along its span is longer
/// than its period: the nodes of each line y = const are placed along x so that all segments
/// between them have the same strain. Throws InputError where zeta is steeper than the flag is
/// long.
template <int dim>
NodeVectors<dim> initial_shape(const InitialSettings&, const std::optional<ShapeFunction>& zeta,
                               const FlagMesh&);

}  // namespace pennon::dns

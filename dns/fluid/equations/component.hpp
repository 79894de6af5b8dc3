/// The components of the fluid's velocity, in the order in which fields keep them: y, z and, where
/// the case has a span or a cross-flow, x.
///
/// Letters: in the equations of the headers v is the velocity vector of the paper, and v_g, v_w, v'
/// are vectors too. Where u, v and w stand together or in code that takes a component, they are the
/// components along x, y and z, as in result files. In code a member `u` (FluidState::u,
/// PlaneFlow::u) holds all components in the order above: u[along_y] is v.
#pragma once

#include <array>
#include <cstddef>

#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"

namespace pennon::dns {

enum Component : std::size_t { along_y, along_z, along_x };

/// The component along each of the axes x, y, z; and the axis of each component.
inline constexpr std::array<Component, 3> component_of = {along_x, along_y, along_z};
inline constexpr std::array<std::size_t, 3> axis_of = {1, 2, 0};

/// The uniform stream by component: V = 1 along y and U along x.
inline std::array<double, 3> uniform_stream(double U) {
  return {1, 0, U};
}

/// The area vector's component; empty along x where there is no span.
template <class Scalar>
const Field<Scalar>& area_along(const FaceMetrics<Scalar>& faces, std::size_t component) {
  if (component == along_x) return faces.area_x;
  return component == along_y ? faces.area_y : faces.area_z;
}

}  // namespace pennon::dns

/// A flag that is held, or moves as prescribed, whatever the fluid does.
#pragma once

#include "dns/flag/shape_function.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

/// The wall of [dns.motion], at the corners of the grid:
///
///   heave  z = A s(t) sin(omega t + phase) c(x)
///   pitch  turned by A s(t) sin(omega t + phase) c(x) radians about (axis, 0)
///   wave   z = A s(t) e(y) sin(k_y y - omega t + phase) c(x),   e = 1 or y
///   mode   z = A s(t) zeta(x, y) sin(omega t + phase)
///
/// c(x) = cos(2 pi waves x/gamma); s(t) rises smoothly from 0 to 1 over the ramp. `zeta` is read
/// for a mode alone.
WallMotion prescribed_motion(const MotionSettings&, const OGrid&, const Span&,
                             const ShapeFunction& zeta = {});

}  // namespace pennon::dns

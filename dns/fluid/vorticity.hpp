/// The vorticity of the fluid, at the cells.
#pragma once

#include "dns/fluid/fluid.hpp"

namespace pennon::dns {

struct Vorticity {
  Field<double> x;         ///< omega_x = dw/dy - dv/dz
  Field<double> y, z;      ///< empty without a span
  Field<double> in_plane;  ///< omega_s of the paper: the size of (omega_y, omega_z); empty without
};

Vorticity vorticity(const Fluid&, const FluidState&);

}  // namespace pennon::dns

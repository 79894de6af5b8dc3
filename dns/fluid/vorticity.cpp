#include "dns/fluid/vorticity.hpp"

#include <cmath>

namespace pennon::dns {
namespace {

// A component's derivatives at the cells.
struct Derivatives {
  Field<double> x, y, z;

  Derivatives(const Fluid& fluid, const FluidState& state, std::size_t component)
      : y(fluid.extent()), z(fluid.extent()) {
    Field<double> f = state.u[component];
    fluid.extend_velocity(component, f);
    const bool has_span = fluid.span().has_span();
    Field<double> f_xi;
    if (has_span) {
      x = Field<double>(fluid.extent());
      f_xi = Field<double>(fluid.extent());
      fluid.span().differentiate(f, f_xi);
    }
    for (int plane = 0; plane < fluid.extent().planes; ++plane)
      gradient(fluid.metrics(), plane, f, has_span ? &f_xi : nullptr,
               {has_span ? &x : nullptr, &y, &z});
  }
};

Field<double> difference(const Field<double>& a, const Field<double>& b) {
  Field<double> result = a;
  for (std::size_t k = 0; k < result.values().size(); ++k) result.values()[k] -= b.values()[k];
  return result;
}

}  // namespace

Vorticity vorticity(const Fluid& fluid, const FluidState& state) {
  const Derivatives v(fluid, state, along_y), w(fluid, state, along_z);
  Vorticity omega;
  omega.x = difference(w.y, v.z);
  if (!fluid.span().has_span()) return omega;
  const Derivatives u(fluid, state, along_x);
  omega.y = difference(u.z, w.x);
  omega.z = difference(v.x, u.y);
  omega.in_plane = omega.y;
  for (std::size_t k = 0; k < omega.in_plane.values().size(); ++k)
    omega.in_plane.values()[k] = std::hypot(omega.y.values()[k], omega.z.values()[k]);
  return omega;
}

}  // namespace pennon::dns

#include "modes/global/half_plane.hpp"

namespace pennon::modes::global {

HalfPlane::HalfPlane(const Extent& extent, int components, Symmetry symmetry)
    : components_(components),
      n_rho_(extent.n_rho),
      n_theta_(extent.n_theta),
      symmetry_(symmetry) {}

}  // namespace pennon::modes::global

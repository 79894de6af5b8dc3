/// The differences of the convective term that a case can choose.
#pragma once

#include "dns/fluid/equations/stencils.hpp"

namespace pennon::dns {

enum class Convection { kawamura_kuwahara, third_order, central };

inline Upwinding upwinding_of(Convection convection) {
  if (convection == Convection::central) return upwinding::central;
  return convection == Convection::third_order ? upwinding::third_order
                                               : upwinding::kawamura_kuwahara;
}

}  // namespace pennon::dns

/// What the flag of a case is made of, and how its leading edge is held.
#pragma once

#include "common/case/parameters.hpp"
#include "dns/flag/flag.hpp"

namespace pennon::dns {

FlagMaterial material_of(const FlagParameters&);
/// The same of another mass ratio.
FlagMaterial material_of(const FlagParameters&, double mu);

Edge leading_edge_of(const FlagParameters&);

}  // namespace pennon::dns

#include "dns/flag/of_case.hpp"

namespace pennon::dns {

FlagMaterial material_of(const FlagParameters& flag) {
  return material_of(flag, flag.mu);
}

FlagMaterial material_of(const FlagParameters& flag, double mu) {
  return {mu, flag.K_B, flag.K_S, flag.nu_s, flag.damping};
}

Edge leading_edge_of(const FlagParameters& flag) {
  return flag.leading_edge == LeadingEdge::clamped ? Edge::clamped : Edge::pinned;
}

}  // namespace pennon::dns

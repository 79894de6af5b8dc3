/// How exactly the flag and the fluid agree: the table [dns.coupling].
#pragma once

#include <cstdint>

#include "common/case/schema.hpp"

namespace pennon::dns {

struct CouplingSettings {
  /// Root mean square over the flag of what the passes leave of the pressure jump, in rho_f V^2; of
  /// jumps larger than 1 it is relative.
  double tolerance = 1e-5;
  std::int64_t most_passes = 50;
};

void declare(Schema&, CouplingSettings&);

}  // namespace pennon::dns

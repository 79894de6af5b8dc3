#include "dns/coupling/settings.hpp"

namespace pennon::dns {

void declare(Schema& schema, CouplingSettings& coupling) {
  schema.table("dns.coupling", "How a flag that the flow moves and the fluid are made to agree.")
      .key({"tolerance", &coupling.tolerance,
            "pressure jump that the passes of a step leave, root mean square over the flag, in "
            "rho_f V^2; relative where the jump is larger than 1",
            Range{1e-12, 1e-1}})
      .key({"most_passes", &coupling.most_passes, "of a step", Range{1, 1000}});
}

}  // namespace pennon::dns

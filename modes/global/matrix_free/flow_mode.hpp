/// A global mode as the simulation that starts in it needs it.
#pragma once

#include "dns/coupling/flow_mode.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/solve/spectrum.hpp"

namespace pennon::modes::global {

/// The mode of the pair, scaled so that the largest displacement of the flag is 1, or as it is if
/// the flag does not move in it.
dns::FlowMode flow_mode(const BaseFlow&, const FlagOperator&, const CoupledOperator&,
                        const Eigenpair&, double k_x);

}  // namespace pennon::modes::global

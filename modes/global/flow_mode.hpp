/// A global mode as the simulation that starts in it needs it.
#pragma once

#include "dns/flow_mode.hpp"
#include "modes/global/coupled_operator.hpp"
#include "modes/global/flag_operator.hpp"
#include "modes/global/spectrum.hpp"

namespace pennon::modes::global {

/// The pair scaled so that the largest displacement of the flag is 1, or left as it is if the flag
/// rests.
dns::FlowMode flow_mode(const BaseFlow&, const FlagOperator&, const CoupledOperator&,
                        const Eigenpair&, double k_x);

}  // namespace pennon::modes::global

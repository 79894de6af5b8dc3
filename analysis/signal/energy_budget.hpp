/// The energies of flag and fluid over a run, per span in rho_f V^2 L^2, and their budget.
///
///     total    = kinetic (of the velocity less the stream) + flag_kinetic + bending + stretch +
///                gravity
///     received = integral of D V + S U + outer_power
///     lost     = integral of dissipation + damping
///     defect   = total - total(0) - received + lost
///
/// D = C_D/2 and S = C_S/2, drag and side force, enter because the fluid's energy is that of the
/// velocity less the stream: what holds the leading edge against the stream works on it. While the
/// stream rises, V and U are what it has risen to.
///
/// The defect is what the method makes or loses: that of the fluid's own budget, that of the
/// flag's, and that of the exchange, which the fluid counts as wall_power (of the flag on the
/// fluid, with the velocity less the stream) and the flag as fluid_work (of the fluid on the flag):
///
///     defect = energy_defect + flag_defect + exchange,
///     exchange = integral of wall_power - D V - S U + fluid_work.
///
/// The work of a kick at the start is in fluid_work and no exchange: it is taken out.
#pragma once

#include <vector>

#include "analysis/signal/run_context.hpp"
#include "analysis/signal/run_history.hpp"

namespace pennon::analysis {

struct EnergyBudget {
  std::vector<double> t;
  std::vector<double> fluid, flag_kinetic, bending, stretch, gravity, flag, total;
  std::vector<double> received, lost, exchange, defect;
  std::vector<double> balance;  ///< total - received
  double residual = 0;  ///< the largest |defect| over the largest kinetic energy of flag and fluid
  double residual_exchange = 0;  ///< of the exchange alone, on the same
  /// The largest change of the defect in one convective period, over the total without gravity at
  /// its end: gravity's energy has no zero of its own.
  double residual_per_time = 0;
};

EnergyBudget energy_budget(const RunHistory&, const RunContext&);

/// The change of a quantity over the convective period before each row, over what it is relative to
/// there; NaN in the first period. Of the total less what was received, relative to itself, it is
/// E_t of the paper's Table 2; of the defect, relative to the total, the method's error.
std::vector<double> change_in_convective_period(const std::vector<double>& t,
                                                const std::vector<double>& values,
                                                const std::vector<double>& relative_to);

}  // namespace pennon::analysis

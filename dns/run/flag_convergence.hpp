/// One flag on several grids or with several time steps: how its equilibrium's deflection (figures
/// 21 and 23 of Banerjee, Connell & Yue 2015) or its frequency (figure 22) converges.
#pragma once

#include <vector>

#include "common/case/parameters.hpp"
#include "common/io/output_folder.hpp"
#include "dns/run/settings.hpp"

namespace pennon::dns {

enum class Refinement { grid, step };

struct Convergence {
  Refinement refinement = Refinement::grid;
  std::vector<double> sizes;   ///< nodes along each side, or time steps in L/V
  std::vector<double> values;  ///< z of the probe in L, or its angular frequency in V/L
  double limit = 0;  ///< the reference; without one, of the last two by Richardson at second order
  bool is_limit_given = false;
  double order = 0;  ///< of |value - limit| in the spacing or step, least squares over all

  /// 1/(n - 1), or the time step.
  double spacing(std::size_t k) const;
};

/// Runs the flag for each n or dt of [dns.convergence] in a folder of its own below the given one,
/// n-<n> or dt-<dt>. Throws as run_flag(), and SolverError where the probe does not vibrate.
Convergence run_convergence(const Settings&, const FlagParameters&, const OutputFolder&,
                            bool shows_progress);

}  // namespace pennon::dns

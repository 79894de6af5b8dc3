/// The equilibrium of one flag on several grids: how its deflection converges (figures 21 and 23 of
/// Banerjee, Connell & Yue 2015).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "common/output_folder.hpp"
#include "common/parameters.hpp"
#include "dns/settings.hpp"

namespace pennon::dns {

struct Convergence {
  std::vector<std::int64_t> n;     ///< nodes along each side
  std::vector<double> deflection;  ///< z of the probe, in L
  double limit = 0;  ///< the reference; without one, of the last two grids by Richardson
  bool is_limit_given = false;
  double order = 0;  ///< of |deflection - limit| in 1/(n - 1), least squares over all grids
};

/// Runs the equilibrium for each n of [dns.convergence] in a folder of its own, n-<n>, and writes
/// convergence.csv and convergence.h5 (kind = "flag_convergence"). Throws as run() of flag_run.hpp.
Convergence run_convergence(const Settings&, const FlagParameters&, const OutputFolder&,
                            bool shows_progress);

/// The value of "convergence" beside "dns" in summary.json.
nlohmann::ordered_json to_json(const Convergence&);

}  // namespace pennon::dns

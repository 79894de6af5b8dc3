#include "dns/run/convergence_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "common/case/about_key.hpp"

namespace pennon::dns {
namespace {

template <class Order, class Value>
bool is_list_in(Order out_of_order, const std::vector<Value>& values) {
  return values.size() >= 2 && std::ranges::adjacent_find(values, out_of_order) == values.end();
}

}  // namespace

void declare(Schema& schema, ConvergenceSettings& convergence) {
  constexpr Range node_count{3, 100'000};
  schema
      .table("dns.convergence",
             "One flag refined: its equilibrium on several grids of n x n nodes, and the error of "
             "the probe's z; or its vibration with several time steps dt, and the error of the "
             "probe's frequency.",
             &convergence.is_given)
      .key({"n", &convergence.n, "nodes along each side, for each grid", node_count})
      .key({"dt", &convergence.dt, "time steps, in L/V, instead of n", positive})
      .key({"reference", &convergence.reference,
            "exact z of the probe, in L, or its exact angular frequency, in V/L", any_sign, false,
            "extrapolated from the last two"});
}

void check(const ConvergenceSettings& convergence, const FlagSettings& flag,
           const OutputSettings& output, double t_end, const FlagParameters& parameters,
           Faults& faults) {
  if (convergence.n.empty() == convergence.dt.empty()) {
    about_key(faults, "dns.convergence",
              "needs either n, to compare grids, or dt, to compare time steps");
  } else if (convergence.dt.empty()) {
    if (!flag.equilibrium)
      about_key(faults, "dns.convergence.n",
                "compares equilibria; dns.flag.equilibrium = true is missing");
    if (!is_list_in(std::greater_equal<>(), convergence.n))
      about_key(faults, "dns.convergence.n",
                "must list at least two numbers of nodes in increasing order");
    const std::int64_t most = std::ranges::max(convergence.n);
    check_nodes("dns.convergence.n", most, most, parameters, faults);
  } else {
    if (flag.equilibrium)
      about_key(faults, "dns.convergence.dt",
                "compares vibrations; dns.flag.equilibrium = true finds a shape at rest instead");
    if (!is_list_in(std::less_equal<>(), convergence.dt))
      about_key(faults, "dns.convergence.dt",
                "must list at least two time steps in decreasing order");
    check_steps("dns.convergence.dt", std::ranges::min(convergence.dt), t_end, faults);
    if (output.history_interval != 0)
      about_key(faults, "dns.output.history_interval",
                fmt::format("= {} leaves steps out; dns.convergence.dt needs every one: 0 is right",
                            output.history_interval));
  }
}

void check_steps(const std::string& key, double dt, double t_end, Faults& faults) {
  constexpr double most_steps = 1e9;
  if (t_end / dt > most_steps)
    about_key(faults, key,
              fmt::format("= {} makes {:.3g} steps to dns.t_end = {}; a run has at most {:.0e}", dt,
                          t_end / dt, t_end, most_steps));
}

}  // namespace pennon::dns

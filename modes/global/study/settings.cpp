#include "modes/global/study/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace pennon::modes::global {
namespace {

constexpr Range cell_count{6, 2000};

}  // namespace

void declare(Schema& schema, Settings& settings) {
  schema
      .table("modes.global",
             "Global eigenmodes of flow and flag, about the steady flow past the flat flag, by the "
             "equations of [dns].",
             &settings.is_given)
      .key({"n_modes", &settings.n_modes,
            "modes of flag or wake sought, next to each target; 0: none, where a neutral curve is "
            "all that is wanted",
            Range{0, 200}})
      .key({"target", &settings.target,
            "growth rate and angular frequency near which modes are sought, in V/L; more such "
            "pairs may "
            "follow, whose modes are merged into one spectrum; left out: the n_modes leading modes "
            "up to an angular frequency of about 13, in a cross-flow with waves along the span of "
            "either sign (negative: the wave travels with the cross-flow)",
            any_sign})
      .key({"k_x", &settings.k_x, "spanwise wavenumber, in 1/L", ranges::k_x, false,
            "2 pi/gamma, in two dimensions 0"})
      .key({"n_rho", &settings.n_rho, "cells from the flag to the outer boundary", cell_count,
            false, "dns.n_rho"})
      .key({"n_theta", &settings.n_theta, "cells around the flag, an even number", cell_count,
            false, "dns.n_theta"})
      .key({"n_x", &settings.n_x,
            "stations of the flag along one wave: its differences along the span are those of a "
            "simulation with so many",
            Range{3, 1e5}, false, "dns.n_x"})
      .key({"R", &settings.R, "radius of the outer boundary, in L", Range{1, 1e4}, false, "dns.R"})
      .key({"wall_spacing", &settings.wall_spacing, "of rho at the flag", Range{1e-6, 1}, false,
            "dns.wall_spacing"})
      .key({"wake_clustering", &settings.wake_clustering, "as dns.wake_clustering", Range{0, 0.9},
            false, "dns.wake_clustering"})
      .key({"dt", &settings.dt,
            "time step of the simulation whose modes these are, in L/V: it enters the discrete "
            "continuity equation",
            not_negative, false, "dns.dt"})
      .key({"convection",
            choice(settings.convection, {"kawamura_kuwahara", "third_order", "central"}),
            "as dns.fluid.convection", any_sign, false, "dns.fluid.convection"})
      .key(
          {"adjoint", &settings.adjoint,
           "find the adjoint modes too, and what a little more of mu, K_B, nu_s or tension does to "
           "each mode"})
      .key({"frames", &settings.frames,
            "frames of an animation of each mode of flag or wake over its period "
            "(global_mode_1.xdmf, ...), with velocity vectors and the flag; 0: none",
            Range{0, 1000}})
      .key({"ranks", &settings.ranks,
            "processes that share the sparse factors and the solutions with them, started by "
            "mpiexec",
            Range{1, 1024}});
  declare(schema, settings.neutral);
  declare(schema, settings.map);
}

void check(const Settings& settings, const FlagParameters& flag, bool has_flow, bool is_asked_for,
           Faults& faults) {
  if (!settings.is_given)
    for (const auto& [is_given, table] :
         {std::pair(settings.neutral.is_given, "modes.global.neutral"),
          std::pair(settings.map.is_given, "modes.global.map")})
      if (is_given) faults.about(table, fmt::format("[{}] needs [modes.global] beside it", table));
  if (!settings.is_given && !is_asked_for) return;
  check(settings.neutral, faults);
  check(settings.map, faults);
  if (!has_flow)
    faults.about("modes.global",
                 "[modes.global] needs [flow]: Re, the Reynolds number V L/nu, has no default");
  if (!(flag.mu > 0)) faults.about("flag.mu", "[modes.global] needs flag.mu, the mass ratio");
  if (!settings.target.empty() && settings.target.size() % 2 != 0)
    faults.about("modes.global.target",
                 fmt::format("modes.global.target holds {} numbers; it is [growth rate, angular "
                             "frequency], or several such pairs one after the other",
                             settings.target.size()));
  if (settings.n_theta % 2 != 0)
    faults.about("modes.global.n_theta",
                 fmt::format("modes.global.n_theta = {} must be even", settings.n_theta));
  for (const auto& [key, cells] :
       {std::pair("n_rho", settings.n_rho), std::pair("n_theta", settings.n_theta)})
    if (static_cast<double>(cells) > cell_count.high)
      faults.about(
          fmt::format("modes.global.{}", key),
          fmt::format("modes.global.{0} = {1}, which dns.{0} gives, is more than {2}: give "
                      "modes.global.{0}",
                      key, cells, cell_count.high));
  for (const double g : flag.gravity)
    if (g != 0) {
      faults.about("flag.gravity", "[modes.global] does not know flag.gravity: it must be 0");
      break;
    }
}

Settings resolve(Settings settings, const FlagParameters& flag, const Discretisation& dns) {
  const double fundamental = flag.gamma ? 2 * std::numbers::pi / *flag.gamma : 0;
  settings.k_x = settings.k_x.value_or(fundamental);
  if (settings.n_rho == 0) settings.n_rho = dns.n_rho;
  if (settings.n_theta == 0) settings.n_theta = dns.n_theta;
  if (settings.n_x == 0) settings.n_x = dns.n_x;
  settings.R = settings.R.value_or(dns.R);
  settings.wall_spacing = settings.wall_spacing.value_or(dns.wall_spacing);
  settings.wake_clustering = settings.wake_clustering.value_or(dns.wake_clustering);
  settings.dt = settings.dt.value_or(dns.dt);
  settings.convection = settings.convection.value_or(dns.convection);
  return settings;
}

Problem::Problem() {
  declare(schema, flag);
  declare(schema, flow, has_flow_);
  declare(schema, settings);
}

Problem::Problem(const FlagParameters& the_flag, const FlowParameters& the_flow,
                 const Settings& the_settings)
    : Problem() {
  flag = the_flag;
  flow = the_flow;
  settings = the_settings;
  settings.is_given = true;
  has_flow_ = true;
}

}  // namespace pennon::modes::global

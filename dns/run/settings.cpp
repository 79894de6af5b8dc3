#include "dns/run/settings.hpp"

#include "common/case/about_key.hpp"

namespace pennon::dns {
namespace {

void declare_run(Schema& schema, Settings& settings) {
  constexpr Range node_count{3, 100'000};
  Table& dns = schema.table(
      "dns", "The direct simulation. Without [flow]: the flag by itself (section 3.2).",
      &settings.is_given);
  dns.key({"dt", &settings.dt, "time step, in L/V; with cfl, the largest", positive})
      .key({"cfl", &settings.fluid.cfl,
            "Courant number that the fluid's time step keeps to; left out: the step is dt",
            Range{1e-3, 1e3}})
      .key({"first_dt", &settings.fluid.first_dt,
            "the fluid's first step, from which the steps grow by a fifth to dt", positive, false,
            "dt; with a flag that the flow moves dt/20, unless it starts as a global mode"})
      .key({"t_end", &settings.t_end, "end of the run, in L/V", positive})
      .key({"n_x", &settings.n_x,
            "stations of the flag and planes of the fluid along the span; not used in two "
            "dimensions",
            node_count});
  declare_grid(dns, settings.fluid);
}

// What a flag that the flow moves cannot have.
void check_coupled(const Settings& settings, Faults& faults) {
  const FlagSettings& flag = settings.flag;
  if (flag.trailing_edge != Edge::free || flag.side_edges != Edge::periodic || flag.equilibrium)
    about_key(faults, "dns.flag",
              "trailing_edge, side_edges or equilibrium is for a flag by itself: in the flow the "
              "trailing edge is free and the span periodic");
  if (settings.loads.are_there())
    about_key(faults, "dns.loads",
              "are for a flag by itself; in the flow dns.initial.kick and flag.gravity act");
  if (settings.convergence.is_given)
    about_key(faults, "dns.convergence", "is of a flag by itself; leave [flow] out");
  if (settings.initial.kick != 0 &&
      settings.initial.release + settings.initial.kick_duration > settings.t_end)
    about_key(faults, "dns.initial.kick", "lasts beyond dns.t_end");
}

}  // namespace

void declare(Schema& schema, Settings& settings) {
  declare_run(schema, settings);
  declare(schema, settings.fluid);
  declare(schema, settings.motion);
  declare(schema, settings.coupling);
  declare(schema, settings.probes);
  declare(schema, settings.flag);
  declare(schema, settings.loads);
  declare(schema, settings.initial);
  declare(schema, settings.output);
  declare(schema, settings.convergence);
}

void check(const Settings& settings, const FlagParameters& flag, bool has_flow, bool is_asked_for,
           Faults& faults) {
  if (!settings.is_given && !is_asked_for) return;
  const bool is_coupled = has_flow && !settings.motion.is_given;
  if (!settings.flag.equilibrium) check_steps("dns.dt", settings.dt, settings.t_end, faults);
  if (has_flow) {
    check(settings.fluid, settings.n_x, settings.dt, flag, faults);
    check(settings.probes, settings.fluid.R, faults);
    if (settings.motion.is_given) check(settings.motion, settings.n_x, flag, faults);
  }
  if (settings.motion.is_given && !has_flow)
    about_key(faults, "dns.motion",
              "moves a flag in a flow, but [flow] is missing; a flag by itself moves by "
              "[dns.initial] and [dns.loads]");
  check(settings.flag, settings.n_x, flag, faults);
  check(settings.loads, flag, faults);
  check(settings.initial, settings.flag, flag, faults);
  if (!settings.initial.global_modes.empty())
    check_global_start(settings.initial, flag, is_coupled, faults);
  if (is_coupled) check_coupled(settings, faults);
  if (settings.convergence.is_given)
    check(settings.convergence, settings.flag, settings.output, settings.t_end, flag, faults);
}

std::optional<NormalModeUse> normal_mode_of(const Settings& settings, bool has_flow) {
  const MotionSettings& motion = settings.motion;
  const InitialSettings& initial = settings.initial;
  if (has_flow && motion.is_given) {
    if (motion.kind != MotionKind::mode) return std::nullopt;
    return NormalModeUse{"dns.motion", motion.n, motion.m};
  }
  if (initial.mode_amplitude == 0 || !initial.global_modes.empty()) return std::nullopt;
  return NormalModeUse{"dns.initial", initial.n, initial.m};
}

}  // namespace pennon::dns

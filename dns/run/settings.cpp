#include "dns/run/settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

namespace pennon::dns {
namespace {

constexpr double most_steps = 1e9;
constexpr double most_nodes = 1e6;
constexpr double most_cells = 1e9;
constexpr Range node_count{3, 100'000};
constexpr Range cell_count{6, 10'000};

template <class Order, class Value>
bool is_list_in(Order out_of_order, const std::vector<Value>& values) {
  return values.size() >= 2 && std::ranges::adjacent_find(values, out_of_order) == values.end();
}

template <class About>
void check(const ConvergenceSettings& convergence, const Settings& settings, const About& about) {
  if (convergence.n.empty() == convergence.dt.empty()) {
    about("convergence", "needs either n, to compare grids, or dt, to compare time steps");
  } else if (convergence.dt.empty()) {
    if (!settings.flag.equilibrium)
      about("convergence.n", "compares equilibria; dns.flag.equilibrium = true is missing");
    if (!is_list_in(std::greater_equal<>(), convergence.n))
      about("convergence.n", "must list at least two numbers of nodes in increasing order");
  } else {
    if (settings.flag.equilibrium)
      about("convergence.dt",
            "compares vibrations; dns.flag.equilibrium = true finds a shape at rest instead");
    if (!is_list_in(std::less_equal<>(), convergence.dt))
      about("convergence.dt", "must list at least two time steps in decreasing order");
    if (settings.output.history_interval != 0)
      about("output.history_interval",
            fmt::format("= {} leaves steps out; dns.convergence.dt needs every one: 0 is right",
                        settings.output.history_interval));
  }
}

}  // namespace

void declare(Schema& schema, Settings& settings) {
  schema
      .table("dns", "The direct simulation. Without [flow]: the flag by itself (section 3.2).",
             &settings.is_given)
      .key({"dt", &settings.dt, "time step, in L/V; with cfl, the largest", positive})
      .key({"cfl", &settings.fluid.cfl,
            "Courant number that the fluid's time step keeps to; left out: the step is dt",
            Range{1e-3, 1e3}})
      .key({"first_dt", &settings.fluid.first_dt,
            "the fluid's first step, from which the steps grow by a fifth to dt", positive, false,
            "dt; with a flag that the flow moves dt/20, unless it starts as a global mode"})
      .key({"t_end", &settings.t_end, "end of the run, in L/V", positive})
      .key({"n_x", &settings.n_x,
            "spanwise nodes, and Fourier points of the fluid; not used in two dimensions",
            node_count})
      .key(
          {"n_rho", &settings.fluid.n_rho, "cells from the flag to the outer boundary", cell_count})
      .key(
          {"n_theta", &settings.fluid.n_theta, "cells around the flag, an even number", cell_count})
      .key({"R", &settings.fluid.R, "radius of the outer boundary, in L", Range{1, 1e4}})
      .key({"wall_spacing", &settings.fluid.wall_spacing,
            "of rho at the flag: the first cell is wall_spacing sin(theta)/2 thick, in L",
            Range{1e-6, 1}})
      .key({"wake_clustering", &settings.fluid.wake_clustering,
            "b of theta = t - b sin t: cells are denser toward the wake", Range{0, 0.9}});
  schema.table("dns.fluid", "How the fluid's equations are discretised and solved.")
      .key(
          {"convection",
           choice(settings.fluid.convection, {"kawamura_kuwahara", "third_order", "central"}),
           "differences of the convective term: third-order upwind-biased with three times or once "
           "the least dissipation, or second-order central"})
      .key({"pressure_tolerance", &settings.fluid.tolerances.pressure,
            "error that a step leaves in the pressure, root mean square, in rho_f V^2",
            Range{1e-14, 1}})
      .key({"velocity_tolerance", &settings.fluid.tolerances.velocity,
            "the same of the velocity, in V", Range{1e-14, 1}})
      .key({"grid_tolerance", &settings.fluid.tolerances.grid,
            "last change of a corner of the grid, in L", Range{1e-14, 1e-2}});
  MotionSettings& motion = settings.motion;
  schema
      .table("dns.motion",
             "A flag in the flow that moves as prescribed: heave z = A sin(omega t + phase), pitch "
             "by that angle, wave z = A sin(k_y y - omega t + phase), mode z = A sin(omega t + "
             "phase) times a normal mode; times cos(2 pi waves x/gamma).",
             &motion.is_given)
      .key({"kind", choice(motion.kind, {"rigid", "heave", "pitch", "wave", "mode"}),
            "what it does"})
      .key({"amplitude", &motion.amplitude, "A, in L; of pitch in radians", any_sign})
      .key({"frequency", &motion.frequency, "omega/(2 pi), in V/L", not_negative})
      .key({"phase", &motion.phase, "in radians", any_sign})
      .key({"k_y", &motion.k_y, "wavenumber of the wave, in 1/L", any_sign})
      .key({"envelope", choice(motion.envelope, {"uniform", "linear"}),
            "of the wave along the chord: 1 or y"})
      .key({"axis", &motion.axis, "y of the axis of pitch, in L", any_sign})
      .key({"waves", &motion.waves, "waves along the span", Range{0, 1e4}})
      .key({"ramp", &motion.ramp, "time over which the amplitude rises from 0, in L/V",
            not_negative})
      .key({"n", &motion.n, "waves along the span of the mode, of the family of [modes.normal]",
            Range{0, 200}})
      .key({"m", &motion.m, "rank along the chord of the mode", Range{1, 200}});
  schema.table("dns.coupling", "How a flag that the flow moves and the fluid are made to agree.")
      .key({"tolerance", &settings.coupling.tolerance,
            "pressure jump that the passes of a step leave, root mean square over the flag, in "
            "rho_f "
            "V^2; relative where the jump is larger than 1",
            Range{1e-12, 1e-1}})
      .key({"most_passes", &settings.coupling.most_passes, "of a step", Range{1, 1000}});
  schema
      .table("dns.probes",
             "Places (y, z) where the fluid's velocity and pressure are kept with the history, in "
             "every plane along the span: y[0] with z[0], and so on.")
      .key({"y", &settings.probes.y, "in L", any_sign})
      .key({"z", &settings.probes.z, "in L", any_sign});
  FlagSettings& flag = settings.flag;
  schema.table("dns.flag", "The flag by itself: its nodes, its other edges, its time steps.")
      .key({"n_y", &flag.n_y, "chordwise nodes", node_count})
      .key({"spacing", choice(flag.spacing, {"uniform", "trailing", "both"}),
            "of the chordwise nodes: where they are denser"})
      .key({"trailing_edge", choice(flag.trailing_edge, {"free", "pinned", "clamped"}),
            "how the edge y = 1 is held"})
      .key({"side_edges", choice(flag.side_edges, {"free", "pinned", "clamped", "periodic"}),
            "how the edges x = 0 and x = gamma are held"})
      .key({"scheme", choice(flag.scheme, {"energy_conserving", "backward_difference"}),
            "time stepping, both of second order"})
      .key({"equilibrium", &flag.equilibrium,
            "find the shape at rest under the loads instead of stepping in time"})
      .key({"tolerance", &flag.tolerance, "of Newton's method: last change of a position, in L",
            Range{1e-15, 1e-3}});
  schema.table("dns.loads", "What acts on a flag by itself, beside [flag] gravity.")
      .key({"pressure", &settings.loads.pressure,
            "jump, below minus above, normal to the deformed flag, in rho_f V^2"})
      .key({"load", &settings.loads.load,
            "force per area along x, y, z, keeping its direction, in rho_f V^2"})
      .key({"edge_load", &settings.loads.edge_load,
            "force per span on the trailing edge along x, y, z, in rho_f V^2 L"})
      .key({"traction", &settings.loads.traction,
            "CSV file with columns x, y, f_x, f_y, f_z: force per area, keeping its direction, at "
            "the node "
            "nearest to each place (x, y) at rest; in two dimensions y, f_y, f_z"});
  schema.table("dns.initial", "Where the flag starts, without velocity.")
      .key({"A", &settings.initial.A, "amplitudes of the cosines in (5.1), n = 0, 1, ..., in L"})
      .key({"B", &settings.initial.B, "amplitudes of the sines in (5.1), n = 0, 1, ..., in L"})
      .key({"angle", &settings.initial.angle,
            "of the straight flag about its leading edge, in radians",
            Range{-std::numbers::pi, std::numbers::pi}})
      .key({"plate_mode", &settings.initial.plate_mode,
            "amplitude of sin(pi x/gamma) sin(pi y), the first mode of a plate supported along all "
            "edges, in L"})
      .key({"mode_amplitude", &settings.initial.mode_amplitude,
            "largest displacement of a normal mode of the family of [modes.normal], or of a global "
            "mode, in L"})
      .key({"n", &settings.initial.n, "waves along the span of that mode", Range{0, 200}})
      .key({"m", &settings.initial.m, "rank along the chord of that mode", Range{1, 200}})
      .key(
          {"global_modes", &settings.initial.global_modes,
           "global_modes.h5 of pennon modes: flag and flow start as mode_amplitude times a mode in "
           "it, in its steady flow"})
      .key({"global_mode", &settings.initial.global_mode, "rank of that mode in the file, from 1",
            Range{1, 200}})
      .key({"ramp", &settings.initial.ramp,
            "time over which the stream rises from rest, in L/V; 0: it starts at once",
            not_negative})
      .key({"release", &settings.initial.release,
            "time until which a flag in the flow is held where it starts, while the flow develops; "
            "in L/V",
            not_negative})
      .key({"kick", &settings.initial.kick,
            "momentum per area along z given to a flag in the flow after its release, at the "
            "trailing edge, less in proportion to y; in rho_f V L",
            any_sign})
      .key({"kick_duration", &settings.initial.kick_duration, "of the kick, in L/V", positive});
  schema.table("dns.output", "What is kept, and how often.")
      .key({"history_interval", &settings.output.history_interval,
            "between rows of the history, in L/V; 0: every step", not_negative})
      .key({"shape_interval", &settings.output.shape_interval,
            "between shapes of the flag, in L/V; 0: none", not_negative})
      .key({"field_interval", &settings.output.field_interval,
            "between fields of the fluid, in L/V; 0: none", not_negative})
      .key({"contour_times", &settings.output.contour_times,
            "times at which the strain is drawn on the flag, in L/V: of the kept shapes the "
            "nearest; "
            "none: on six at equal intervals",
            not_negative})
      .key({"checkpoint_interval", &settings.output.checkpoint_interval,
            "between checkpoints, in L/V; 0: at the end only", not_negative})
      .key({"probe_x", &settings.output.probe_x,
            "x at rest of the place whose motion is kept; the nearest node is taken", not_negative})
      .key({"probe_y", &settings.output.probe_y, "y at rest of that place", Range{0, 1}});
  schema
      .table("dns.convergence",
             "One flag refined: its equilibrium on several grids of n x n nodes, and the error of "
             "the probe's z; or its vibration with several time steps dt, and the error of the "
             "probe's frequency.",
             &settings.convergence.is_given)
      .key({"n", &settings.convergence.n, "nodes along each side, for each grid", node_count})
      .key({"dt", &settings.convergence.dt, "time steps, in L/V, instead of n", positive})
      .key({"reference", &settings.convergence.reference,
            "exact z of the probe, in L, or its exact angular frequency, in V/L", any_sign, false,
            "extrapolated from the last two"});
}

namespace {

void check_fluid(const Settings& settings, const FlagParameters& flag, Faults& faults) {
  const auto about = [&](const std::string& key, const std::string& what) {
    faults.about("dns." + key, "dns." + key + " " + what);
  };
  const FluidSettings& fluid = settings.fluid;
  if (fluid.n_theta % 2 != 0)
    about("n_theta", fmt::format("= {} is odd: the edges of the flag must lie on corners of cells; "
                                 "take {} or {}",
                                 fluid.n_theta, fluid.n_theta - 1, fluid.n_theta + 1));
  constexpr std::int64_t least_planes = 4;
  if (flag.gamma && settings.n_x < least_planes)
    about("n_x", fmt::format("= {} is too few: the fluid's Fourier series along the span has at "
                             "least {} points",
                             settings.n_x, least_planes));
  const double cells = static_cast<double>(fluid.n_rho) * static_cast<double>(fluid.n_theta) *
                       (flag.gamma ? static_cast<double>(settings.n_x) : 1.0);
  if (cells > most_cells)
    about("n_rho", fmt::format("= {} makes {:.3g} cells with n_theta and n_x; a grid has at most "
                               "{:.0e}",
                               fluid.n_rho, cells, most_cells));
  if (fluid.first_dt && *fluid.first_dt > settings.dt)
    about("first_dt", fmt::format("= {} is larger than dns.dt = {}", *fluid.first_dt, settings.dt));
  if (settings.probes.y.size() != settings.probes.z.size())
    about("probes.z", fmt::format("has {} numbers and dns.probes.y has {}; each probe has one of "
                                  "each",
                                  settings.probes.z.size(), settings.probes.y.size()));
  for (std::size_t k = 0; k < std::min(settings.probes.y.size(), settings.probes.z.size()); ++k)
    if (std::hypot(settings.probes.y[k] - 0.5, settings.probes.z[k]) >= fluid.R)
      about("probes.y", fmt::format("[{}] lies outside the outer boundary, at the distance dns.R = "
                                    "{} from mid-chord",
                                    k, fluid.R));
  if (settings.motion.is_given && settings.motion.kind != MotionKind::rigid &&
      settings.motion.waves > 0 && !flag.gamma)
    about("motion.waves", "varies along the span, but without flag.gamma there is none");
  if (flag.gamma && 3 * settings.motion.waves >= settings.n_x)
    about("motion.waves", fmt::format("= {} needs dns.n_x of at least {}: the upper third of the "
                                      "Fourier series is dropped",
                                      settings.motion.waves, 3 * settings.motion.waves + 1));
}

// What a flag that the flow moves cannot have.
template <class About>
void check_coupled(const Settings& settings, const About& about) {
  const FlagSettings& flag = settings.flag;
  if (flag.trailing_edge != Edge::free || flag.side_edges != Edge::periodic || flag.equilibrium)
    about("flag",
          "trailing_edge, side_edges or equilibrium is for a flag by itself: in the flow the "
          "trailing edge is free and the span periodic");
  const LoadSettings& loads = settings.loads;
  if (loads.pressure != 0 || loads.load != std::array<double, 3>{} ||
      loads.edge_load != std::array<double, 3>{} || !loads.traction.empty())
    about("loads", "are for a flag by itself; in the flow dns.initial.kick and flag.gravity act");
  if (settings.convergence.is_given)
    about("convergence", "is of a flag by itself; leave [flow] out");
  if (settings.initial.kick != 0 &&
      settings.initial.release + settings.initial.kick_duration > settings.t_end)
    about("initial.kick", "lasts beyond dns.t_end");
}

template <class About>
void check_global_start(const Settings& settings, const FlagParameters& flag, bool has_flow,
                        const About& about) {
  const InitialSettings& initial = settings.initial;
  if (!has_flow || settings.motion.is_given)
    about("initial.global_modes",
          "starts flag and flow together: it needs [flow], and no "
          "[dns.motion]");
  if (initial.mode_amplitude == 0)
    about("initial.mode_amplitude",
          "is missing: the largest displacement of the global mode, in L; 1e-4 starts a linear "
          "phase");
  if (initial.ramp != 0 || initial.release != 0 || initial.kick != 0)
    about("initial.global_modes",
          "starts in the steady flow as if it had come from there; dns.initial.ramp, release and "
          "kick contradict that");
  if (flag.gravity != std::array<double, 3>{})
    about("initial.global_modes", "holds modes of a flag without weight; flag.gravity is given");
}

}  // namespace

void check(const Settings& settings, const FlagParameters& flag, bool has_flow, Faults& faults) {
  if (!settings.is_given) return;
  const auto about = [&](const std::string& key, const std::string& what) {
    faults.about("dns." + key, "dns." + key + " " + what);
  };
  if (has_flow) check_fluid(settings, flag, faults);
  if (!settings.flag.equilibrium && settings.t_end / settings.dt > most_steps)
    about("dt", fmt::format("= {} makes {:.3g} steps to t_end = {}; a run has at most {:.0e}",
                            settings.dt, settings.t_end / settings.dt, settings.t_end, most_steps));
  const double nodes = static_cast<double>(settings.flag.n_y) *
                       (flag.gamma ? static_cast<double>(settings.n_x) : 1.0);
  if (nodes > most_nodes)
    about("flag.n_y",
          fmt::format("= {} with dns.n_x = {} makes {:.3g} nodes; a flag has at most {:.0e}",
                      settings.flag.n_y, settings.n_x, nodes, most_nodes));
  if (!flag.gamma) {
    if (settings.flag.side_edges != Edge::periodic)
      about("flag.side_edges",
            "is given, but without flag.gamma the flag is two-dimensional and has none");
    if (settings.initial.A.size() > 1 || !settings.initial.B.empty())
      about(settings.initial.B.empty() ? "initial.A" : "initial.B",
            "holds spanwise waves, but without flag.gamma the flag is two-dimensional: only A = "
            "[A_0] is right");
    if (settings.loads.load[0] != 0 || settings.loads.edge_load[0] != 0 || flag.gravity[0] != 0)
      about("loads",
            "or flag.gravity acts along x, but without flag.gamma the flag is two-dimensional");
  }
  const bool starts_bent = !settings.initial.A.empty() || !settings.initial.B.empty();
  if (settings.initial.angle != 0 && starts_bent)
    about("initial.angle", "contradicts dns.initial.A or B: the flag starts straight or as (5.1)");
  if (settings.initial.angle != 0 || starts_bent) {
    const char* key = !starts_bent                 ? "initial.angle"
                      : settings.initial.A.empty() ? "initial.B"
                                                   : "initial.A";
    const auto is_held = [](Edge edge) { return edge == Edge::pinned || edge == Edge::clamped; };
    if (is_held(settings.flag.trailing_edge))
      about(key,
            "moves the trailing edge, which dns.flag.trailing_edge holds where it rests: "
            "let that edge be free");
    if (is_held(settings.flag.side_edges))
      about(key,
            "moves the side edges, which dns.flag.side_edges holds where they rest: let them "
            "be free or periodic");
  }
  if (settings.initial.plate_mode != 0) {
    if (starts_bent || settings.initial.angle != 0)
      about("initial.plate_mode",
            "contradicts dns.initial.A, B or angle: the plate starts as one of "
            "them");
    if (!flag.gamma || flag.leading_edge != LeadingEdge::pinned ||
        settings.flag.trailing_edge != Edge::pinned || settings.flag.side_edges != Edge::pinned)
      about("initial.plate_mode",
            "is the mode of a plate supported along all edges: it needs flag.gamma, and "
            "flag.leading_edge, dns.flag.trailing_edge and dns.flag.side_edges = \"pinned\"");
  }
  if (settings.initial.mode_amplitude != 0) {
    if (starts_bent || settings.initial.angle != 0 || settings.initial.plate_mode != 0)
      about("initial.mode_amplitude",
            "contradicts dns.initial.A, B, angle or plate_mode: the flag starts as one of them");
    if (settings.initial.n > 0 && !flag.gamma)
      about("initial.n", "varies along the span, but without flag.gamma there is none");
  }
  if (!settings.initial.global_modes.empty()) check_global_start(settings, flag, has_flow, about);
  if (has_flow && !settings.motion.is_given) check_coupled(settings, about);
  if (settings.convergence.is_given) check(settings.convergence, settings, about);
  if (settings.flag.equilibrium && flag.K_B == 0)
    about("flag.equilibrium",
          "= true needs bending: without flag.K_B a slack flag has no stiffness across; let it "
          "swing with "
          "damping instead");
}

FlagMesh mesh_of(const Settings& settings, const FlagParameters& flag) {
  std::vector<double> chord = uniform_chord(static_cast<int>(settings.flag.n_y));
  for (double& eta : chord) {
    if (settings.flag.spacing == ChordSpacing::trailing) eta = std::sin(std::numbers::pi / 2 * eta);
    if (settings.flag.spacing == ChordSpacing::both)
      eta = (1 - std::cos(std::numbers::pi * eta)) / 2;
  }
  return mesh_of(settings, flag, std::move(chord));
}

FlagMesh mesh_of(const Settings& settings, const FlagParameters& flag, std::vector<double> chord) {
  const Edge leading = flag.leading_edge == LeadingEdge::clamped ? Edge::clamped : Edge::pinned;
  const Edge side = settings.flag.side_edges;
  const EdgeConditions edges{leading, settings.flag.trailing_edge, side, side};
  if (!flag.gamma) return {std::move(chord), edges};
  return {std::move(chord), static_cast<int>(settings.n_x), *flag.gamma, edges};
}

FlagMaterial material_of(const FlagParameters& flag) {
  return {flag.mu, flag.K_B, flag.K_S, flag.nu_s, flag.damping};
}

}  // namespace pennon::dns

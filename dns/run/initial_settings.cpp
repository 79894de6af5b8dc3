#include "dns/run/initial_settings.hpp"

#include <array>
#include <numbers>

#include "common/case/about_key.hpp"

namespace pennon::dns {
namespace {

bool is_held(Edge edge) {
  return edge == Edge::pinned || edge == Edge::clamped;
}

void check_bent_start(const InitialSettings& initial, const FlagSettings& edges, Faults& faults) {
  const bool starts_bent = !initial.A.empty() || !initial.B.empty();
  if (initial.angle != 0 && starts_bent)
    about_key(faults, "dns.initial.angle",
              "contradicts dns.initial.A or B: the flag starts straight or as (5.1)");
  if (initial.angle == 0 && !starts_bent) return;
  const char* key = !starts_bent        ? "dns.initial.angle"
                    : initial.A.empty() ? "dns.initial.B"
                                        : "dns.initial.A";
  if (is_held(edges.trailing_edge))
    about_key(faults, key,
              "moves the trailing edge, which dns.flag.trailing_edge holds where it rests: let "
              "that edge be free");
  if (is_held(edges.side_edges))
    about_key(faults, key,
              "moves the side edges, which dns.flag.side_edges holds where they rest: let them be "
              "free or periodic");
}

}  // namespace

void declare(Schema& schema, InitialSettings& initial) {
  schema.table("dns.initial", "Where the flag starts, without velocity.")
      .key({"A", &initial.A, "amplitudes of the cosines in (5.1), n = 0, 1, ..., in L"})
      .key({"B", &initial.B, "amplitudes of the sines in (5.1), n = 0, 1, ..., in L"})
      .key({"angle", &initial.angle, "of the straight flag about its leading edge, in radians",
            Range{-std::numbers::pi, std::numbers::pi}})
      .key({"plate_mode", &initial.plate_mode,
            "amplitude of sin(pi x/gamma) sin(pi y), the first mode of a plate supported along all "
            "edges, in L"})
      .key({"mode_amplitude", &initial.mode_amplitude,
            "largest displacement of a normal mode of the family of [modes.normal], or of a global "
            "mode, in L"})
      .key({"n", &initial.n, "waves along the span of that mode", Range{0, 200}})
      .key({"m", &initial.m, "number along the chord of that mode, from 1", Range{1, 200}})
      .key(
          {"global_modes", &initial.global_modes,
           "global_modes.h5 of pennon modes: flag and flow start as mode_amplitude times a mode in "
           "it, in its steady flow"})
      .key({"global_mode", &initial.global_mode, "number of that mode in the file, from 1",
            Range{1, 200}})
      .key({"ramp", &initial.ramp,
            "time over which the stream rises from rest, in L/V; 0: it starts at once",
            not_negative})
      .key({"release", &initial.release,
            "time until which a flag in the flow is held where it starts, while the flow develops; "
            "in L/V",
            not_negative})
      .key({"kick", &initial.kick,
            "momentum per area along z given to a flag in the flow after its release, at the "
            "trailing edge, less in proportion to y; in rho_f V L",
            any_sign})
      .key({"kick_duration", &initial.kick_duration, "of the kick, in L/V", positive});
}

void check(const InitialSettings& initial, const FlagSettings& edges, const FlagParameters& flag,
           Faults& faults) {
  const bool starts_bent = !initial.A.empty() || !initial.B.empty();
  if (!flag.gamma && (initial.A.size() > 1 || !initial.B.empty()))
    about_key(faults, initial.B.empty() ? "dns.initial.A" : "dns.initial.B",
              "holds spanwise waves, but without flag.gamma the flag is two-dimensional: only A = "
              "[A_0] is right");
  check_bent_start(initial, edges, faults);
  if (initial.plate_mode != 0) {
    if (starts_bent || initial.angle != 0)
      about_key(faults, "dns.initial.plate_mode",
                "contradicts dns.initial.A, B or angle: the plate starts as one of them");
    if (!flag.gamma || flag.leading_edge != LeadingEdge::pinned ||
        edges.trailing_edge != Edge::pinned || edges.side_edges != Edge::pinned)
      about_key(faults, "dns.initial.plate_mode",
                "is the mode of a plate supported along all edges: it needs flag.gamma, and "
                "flag.leading_edge, dns.flag.trailing_edge and dns.flag.side_edges = \"pinned\"");
  }
  if (initial.mode_amplitude != 0) {
    if (starts_bent || initial.angle != 0 || initial.plate_mode != 0)
      about_key(faults, "dns.initial.mode_amplitude",
                "contradicts dns.initial.A, B, angle or plate_mode: the flag starts as one of "
                "them");
    if (initial.n > 0 && !flag.gamma)
      about_key(faults, "dns.initial.n",
                "varies along the span, but without flag.gamma there is none");
  }
}

void check_global_start(const InitialSettings& initial, const FlagParameters& flag, bool is_coupled,
                        Faults& faults) {
  if (!is_coupled)
    about_key(faults, "dns.initial.global_modes",
              "starts flag and flow together: it needs [flow], and no [dns.motion]");
  if (initial.mode_amplitude == 0)
    about_key(faults, "dns.initial.mode_amplitude",
              "is missing: the largest displacement of the global mode, in L; 1e-4 starts a linear "
              "phase");
  if (initial.ramp != 0 || initial.release != 0 || initial.kick != 0)
    about_key(faults, "dns.initial.global_modes",
              "starts in the steady flow as if it had come from there; dns.initial.ramp, release "
              "and kick contradict that");
  if (flag.gravity != std::array<double, 3>{})
    about_key(faults, "dns.initial.global_modes",
              "holds modes of a flag without weight; flag.gravity is given");
}

}  // namespace pennon::dns

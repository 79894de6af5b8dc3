/// What a case asks of the direct simulation: the tables [dns], [dns.flag], [dns.loads],
/// [dns.initial], [dns.fluid], [dns.motion], [dns.coupling], [dns.probes], [dns.output] and
/// [dns.convergence].
#pragma once

#include <array>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/coupling/settings.hpp"
#include "dns/flag/mesh.hpp"
#include "dns/flag/stepper.hpp"
#include "dns/fluid/equations/convection.hpp"
#include "dns/fluid/parameters.hpp"

namespace pennon::dns {

/// How the chordwise nodes of a flag by itself are spaced.
enum class ChordSpacing {
  uniform,
  trailing,  ///< sin(pi eta/2): denser toward the trailing edge
  both       ///< (1 - cos(pi eta))/2: denser toward both edges
};

struct FlagSettings {
  std::int64_t n_y = 60;
  ChordSpacing spacing = ChordSpacing::uniform;
  Edge trailing_edge = Edge::free;
  Edge side_edges = Edge::periodic;
  TimeScheme scheme = TimeScheme::energy_conserving;
  bool equilibrium = false;  ///< find the shape at rest under the loads instead of stepping
  double tolerance = 1e-10;
};

struct LoadSettings {
  double pressure = 0;                          ///< follower pressure jump, rho_f V^2
  std::array<double, 3> load = {0, 0, 0};       ///< per area, keeping its direction, rho_f V^2
  std::array<double, 3> edge_load = {0, 0, 0};  ///< per span at the trailing edge, rho_f V^2 L
  std::string traction;                         ///< CSV file: force per area at places of the flag
};

struct InitialSettings {
  std::vector<double> A, B;      ///< of (5.1)
  double angle = 0;              ///< of the straight flag about its leading edge, radians
  double plate_mode = 0;         ///< amplitude of sin(pi x/gamma) sin(pi y)
  double mode_amplitude = 0;     ///< of a normal or global mode, at its largest
  std::int64_t n = 0, m = 1;     ///< of that mode: waves along the span, rank along the chord
  std::string global_modes;      ///< file of the global mode; empty: a normal mode
  std::int64_t global_mode = 1;  ///< its rank in that file
  double ramp = 0;               ///< time over which the stream rises
  double release = 0;            ///< time until which a flag in the flow is held
  double kick = 0;               ///< momentum per area given to its trailing edge, rho_f V L
  double kick_duration = 0.1;    ///< in L/V
};

struct ConvergenceSettings {
  bool is_given = false;
  std::vector<std::int64_t> n;      ///< nodes along each side
  std::vector<double> dt;           ///< or time steps
  std::optional<double> reference;  ///< exact z of the probe, or its exact angular frequency
};

enum class MotionKind { rigid, heave, pitch, wave, mode };
enum class Envelope { uniform, linear };

/// How the flag moves whatever the fluid does: see dns/run/prescribed_motion.hpp.
struct MotionSettings {
  bool is_given = false;
  MotionKind kind = MotionKind::rigid;
  double amplitude = 0;  ///< A, in L or radians
  double frequency = 1;  ///< omega/(2 pi), in V/L
  double phase = 0;
  double k_y = 2 * std::numbers::pi;
  Envelope envelope = Envelope::linear;
  double axis = 0;            ///< y of the axis of pitch
  std::int64_t waves = 0;     ///< along the span
  double ramp = 0;            ///< time over which the amplitude rises
  std::int64_t n = 0, m = 1;  ///< of the mode: waves along the span, rank along the chord
};

struct FluidSettings {
  std::int64_t n_rho = 60;
  std::int64_t n_theta = 120;
  double R = 8;
  double wall_spacing = 0.012;
  double wake_clustering = 0;
  std::optional<double> cfl;
  std::optional<double> first_dt;
  Convection convection = Convection::kawamura_kuwahara;
  FluidTolerances tolerances;
};

/// Places of the section where the fluid's velocity and pressure are kept, in every plane.
struct ProbeSettings {
  std::vector<double> y, z;
};

struct OutputSettings {
  double history_interval = 0;        ///< 0: every step
  double shape_interval = 0;          ///< 0: none
  std::vector<double> contour_times;  ///< of the shapes whose strain is drawn; empty: a few
  double field_interval = 0;          ///< 0: none
  double checkpoint_interval = 0;     ///< 0: at the end only
  double probe_x = 0, probe_y = 1;    ///< at rest: the nearest node's motion is kept
};

struct Settings {
  bool is_given = false;
  double dt = 1e-3;
  double t_end = 1;
  std::int64_t n_x = 60;
  FluidSettings fluid;
  MotionSettings motion;
  ProbeSettings probes;
  CouplingSettings coupling;
  FlagSettings flag;
  LoadSettings loads;
  InitialSettings initial;
  OutputSettings output;
  ConvergenceSettings convergence;
};

void declare(Schema&, Settings&);

/// The faults between keys.
void check(const Settings&, const FlagParameters&, bool has_flow, Faults&);

/// The mesh and material of the case's flag.
FlagMesh mesh_of(const Settings&, const FlagParameters&);
/// The same of other chordwise nodes.
FlagMesh mesh_of(const Settings&, const FlagParameters&, std::vector<double> chord);
FlagMaterial material_of(const FlagParameters&);

}  // namespace pennon::dns

/// What a case asks of the direct simulation: the tables [dns], [dns.flag], [dns.loads],
/// [dns.initial], [dns.output] and [dns.convergence].
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/case_reader.hpp"
#include "common/parameters.hpp"
#include "dns/flag_mesh.hpp"
#include "dns/flag_stepper.hpp"

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
  std::vector<double> A, B;  ///< of (5.1)
  double angle = 0;          ///< of the straight flag about its leading edge, radians
  double plate_mode = 0;     ///< amplitude of sin(pi x/gamma) sin(pi y)
};

struct ConvergenceSettings {
  bool is_given = false;
  std::vector<std::int64_t> n;      ///< nodes along each side
  std::vector<double> dt;           ///< or time steps
  std::optional<double> reference;  ///< exact z of the probe, or its exact angular frequency
};

struct OutputSettings {
  double history_interval = 0;        ///< 0: every step
  double shape_interval = 0;          ///< 0: none
  std::vector<double> contour_times;  ///< of the shapes whose strain is drawn; empty: a few
  double checkpoint_interval = 0;     ///< 0: at the end only
  double probe_x = 0, probe_y = 1;    ///< at rest: the nearest node's motion is kept
};

struct Settings {
  bool is_given = false;
  double dt = 1e-3;
  double t_end = 1;
  std::int64_t n_x = 60;
  FlagSettings flag;
  LoadSettings loads;
  InitialSettings initial;
  OutputSettings output;
  ConvergenceSettings convergence;
};

void declare(Schema&, Settings&);

/// The faults between keys.
void check(const Settings&, const FlagParameters&, Faults&);

/// The mesh and material of the case's flag.
FlagMesh mesh_of(const Settings&, const FlagParameters&);
FlagMaterial material_of(const FlagParameters&);

}  // namespace pennon::dns

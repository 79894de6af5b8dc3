/// The discretisation of a flag by itself: the table [dns.flag]. A flag in a flow uses none of it:
/// its nodes are those of the fluid's grid, its trailing edge is free, its span periodic, and its
/// steps are the coupling's.
#pragma once

#include <cstdint>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "dns/flag/mesh.hpp"
#include "dns/flag/stepper.hpp"

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

void declare(Schema&, FlagSettings&);
/// `n_x`: the number of stations along the span.
void check(const FlagSettings&, std::int64_t n_x, const FlagParameters&, Faults&);
/// Adds a fault where n_y times n_x nodes are too many; `key` is the key that the fault names.
void check_nodes(const std::string& key, std::int64_t n_y, std::int64_t n_x, const FlagParameters&,
                 Faults&);

/// The mesh of the case's flag with `n_x` stations.
FlagMesh mesh_of(const FlagSettings&, std::int64_t n_x, const FlagParameters&);
/// The same with these chordwise nodes instead of those of the settings.
FlagMesh mesh_of(const FlagSettings&, std::int64_t n_x, const FlagParameters&,
                 std::vector<double> chord);

}  // namespace pennon::dns

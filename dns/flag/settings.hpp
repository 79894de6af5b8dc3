/// The flag's discretisation: the table [dns.flag]. Of a flag in the flow only the tolerance and
/// the scheme's defaults matter; its nodes are those of the fluid's grid.
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
/// `n_x`: the spanwise nodes.
void check(const FlagSettings&, std::int64_t n_x, const FlagParameters&, Faults&);
/// The sentence about too many nodes, where there are; `key` is the one that makes them.
void check_nodes(const std::string& key, std::int64_t n_y, std::int64_t n_x, const FlagParameters&,
                 Faults&);

/// The mesh of the case's flag with `n_x` spanwise nodes.
FlagMesh mesh_of(const FlagSettings&, std::int64_t n_x, const FlagParameters&);
/// The same of other chordwise nodes.
FlagMesh mesh_of(const FlagSettings&, std::int64_t n_x, const FlagParameters&,
                 std::vector<double> chord);

}  // namespace pennon::dns

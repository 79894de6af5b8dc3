#include "dns/flag/settings.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/case/about_key.hpp"
#include "dns/flag/of_case.hpp"

namespace pennon::dns {

void declare(Schema& schema, FlagSettings& flag) {
  constexpr Range node_count{3, 100'000};
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
}

void check_nodes(const std::string& key, std::int64_t n_y, std::int64_t n_x,
                 const FlagParameters& flag, Faults& faults) {
  constexpr double most_nodes = 1e6;
  const double nodes = static_cast<double>(n_y) * (flag.gamma ? static_cast<double>(n_x) : 1.0);
  if (nodes > most_nodes)
    about_key(faults, key,
              fmt::format("= {} with {} along the span makes {:.3g} nodes; a flag has at most "
                          "{:.0e}",
                          n_y, n_x, nodes, most_nodes));
}

void check(const FlagSettings& settings, std::int64_t n_x, const FlagParameters& flag,
           Faults& faults) {
  check_nodes("dns.flag.n_y", settings.n_y, n_x, flag, faults);
  if (!flag.gamma && settings.side_edges != Edge::periodic)
    about_key(faults, "dns.flag.side_edges",
              "is given, but without flag.gamma the flag is two-dimensional and has none");
  if (settings.equilibrium && flag.K_B == 0)
    about_key(faults, "dns.flag.equilibrium",
              "= true needs bending: without flag.K_B a slack flag has no stiffness across; let it "
              "swing with damping instead");
}

FlagMesh mesh_of(const FlagSettings& settings, std::int64_t n_x, const FlagParameters& flag) {
  std::vector<double> chord = uniform_chord(static_cast<int>(settings.n_y));
  for (double& eta : chord) {
    if (settings.spacing == ChordSpacing::trailing) eta = std::sin(std::numbers::pi / 2 * eta);
    if (settings.spacing == ChordSpacing::both) eta = (1 - std::cos(std::numbers::pi * eta)) / 2;
  }
  return mesh_of(settings, n_x, flag, std::move(chord));
}

FlagMesh mesh_of(const FlagSettings& settings, std::int64_t n_x, const FlagParameters& flag,
                 std::vector<double> chord) {
  const Edge side = settings.side_edges;
  const EdgeConditions edges{leading_edge_of(flag), settings.trailing_edge, side, side};
  if (!flag.gamma) return {std::move(chord), edges};
  return {std::move(chord), static_cast<int>(n_x), *flag.gamma, edges};
}

}  // namespace pennon::dns

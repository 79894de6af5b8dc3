#include "dns/flag/mesh.hpp"

#include <utility>

namespace pennon::dns {

FlagMesh::FlagMesh(std::vector<double> chord, EdgeConditions edges)
    : chord_(std::move(chord)), stations_(1), span_(1), dx_(1), edges_(edges) {
  assert(chord_.size() >= 3);
  edges_.left = edges_.right = Edge::periodic;
}

FlagMesh::FlagMesh(std::vector<double> chord, int stations, double span, EdgeConditions edges)
    : chord_(std::move(chord)), stations_(stations), span_(span), edges_(edges) {
  assert(chord_.size() >= 3 && stations >= 3 && span > 0);
  assert((edges.left == Edge::periodic) == (edges.right == Edge::periodic));
  dx_ = span / (is_periodic() ? stations : stations - 1);
}

double FlagMesh::chord_share(int j) const {
  const double before = j > 0 ? dy(j - 1) : 0;
  const double after = j + 1 < chord_nodes() ? dy(j) : 0;
  return (before + after) / 2;
}

double FlagMesh::span_share(int i) const {
  const bool is_at_an_end = !is_periodic() && (i == 0 || i == stations_ - 1);
  return is_at_an_end ? dx_ / 2 : dx_;
}

std::vector<double> uniform_chord(int nodes) {
  std::vector<double> chord(static_cast<std::size_t>(nodes));
  for (int j = 0; j < nodes; ++j)
    chord[static_cast<std::size_t>(j)] = static_cast<double>(j) / (nodes - 1);
  return chord;
}

}  // namespace pennon::dns

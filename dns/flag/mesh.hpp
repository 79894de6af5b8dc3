/// The Lagrangian grid of a flag: nodes (i, j) at s_2 = x_i along the span and s_1 = y_j along the
/// chord, and how its edges are held. The chordwise nodes may cluster; the spanwise ones are
/// equally spaced.
///
/// A station is a spanwise position of nodes: station i is the row of nodes at s_2 = x_i. In a
/// simulation with a fluid it lies in the plane i of the fluid's grid (wall_faces.hpp). One station
/// is the flag in two dimensions, which moves in the (y, z) plane.
#pragma once

#include <cassert>
#include <cstddef>
#include <vector>

namespace pennon::dns {

enum class Edge {
  free,
  pinned,   ///< position held, slope free (a simply supported edge of a plate)
  clamped,  ///< position and slope held, as the flag lies at rest
  periodic  ///< both spanwise edges: the flag repeats after its span
};

struct EdgeConditions {
  Edge leading = Edge::pinned;  ///< s_1 = 0
  Edge trailing = Edge::free;   ///< s_1 = 1
  Edge left = Edge::periodic;   ///< s_2 = 0
  Edge right = Edge::periodic;  ///< s_2 = span
};

class FlagMesh {
 public:
  /// In two dimensions. `chord` increases from 0, at least three nodes.
  FlagMesh(std::vector<double> chord, EdgeConditions edges);
  /// `stations` equally spaced over the span (`span`, in L): from 0 to one spacing before its end
  /// where the span is periodic, to its end elsewhere.
  FlagMesh(std::vector<double> chord, int stations, double span, EdgeConditions edges);

  bool is_two_d() const { return stations_ == 1; }
  bool is_periodic() const { return edges_.left == Edge::periodic; }
  int dimension() const { return is_two_d() ? 2 : 3; }
  int stations() const { return stations_; }
  int chord_nodes() const { return static_cast<int>(chord_.size()); }
  int nodes() const { return stations_ * chord_nodes(); }
  int index(int i, int j) const { return i * chord_nodes() + j; }
  const EdgeConditions& edges() const { return edges_; }

  double span() const { return span_; }  ///< 1 in two dimensions: forces are per unit span
  double y(int j) const { return chord_[static_cast<std::size_t>(j)]; }
  double x(int i) const { return i * dx_; }
  double dx() const { return dx_; }
  double dy(int j) const { return y(j + 1) - y(j); }  ///< of the segment from j to j + 1
  /// Length of chord and of span that a node stands for, in L; their product is its area.
  double chord_share(int j) const;
  double span_share(int i) const;
  double area(int i, int j) const { return chord_share(j) * span_share(i); }

 private:
  std::vector<double> chord_;
  int stations_;
  double span_;
  double dx_;
  EdgeConditions edges_;
};

/// N equally spaced nodes from 0 to 1.
std::vector<double> uniform_chord(int nodes);

}  // namespace pennon::dns

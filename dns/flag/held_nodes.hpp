/// The nodes of a flag that its edge conditions hold: they do not move and have no unknowns.
#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

namespace pennon::dns {

class HeldNodes {
 public:
  /// Says of each node of the mesh whether it is held.
  explicit HeldNodes(std::vector<bool> is_held) : is_held_(std::move(is_held)) {}

  int nodes() const { return static_cast<int>(is_held_.size()); }
  bool contains(int node) const { return is_held_[static_cast<std::size_t>(node)]; }

  /// Sets the columns of the held nodes to zero; a column for each node.
  template <int dim>
  void clear(Eigen::Matrix<double, dim, Eigen::Dynamic>& vectors) const {
    for (int node = 0; node < nodes(); ++node)
      if (contains(node)) vectors.col(node).setZero();
  }

 private:
  std::vector<bool> is_held_;
};

}  // namespace pennon::dns

/// A follower pressure on the flag: it stays normal to the deformed surface.
///
/// Each cell (in two dimensions each segment) carries the jump p, below minus above, on its area
/// vector, shared equally by its nodes: 1/2 (x_11 - x_00) x (x_01 - x_10) for a cell, the
/// difference vector turned by 90 degrees for a segment. At rest the area vectors point along z.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dns/flag/mesh.hpp"
#include "dns/flag/step.hpp"
#include "dns/flag/tangent_matrix.hpp"

namespace pennon::dns {

template <int dim>
class PressureLoad {
 public:
  explicit PressureLoad(const FlagMesh&);

  /// The number of cells, or of segments. They are counted station by station, along the chord.
  int elements() const { return static_cast<int>(elements_.size()); }

  /// Adds the forces of the jumps `p`, one for each element, in rho_f V^2. With
  /// Pairing::discrete_gradient the surface is that of the mean positions.
  void add_forces(const FlagStep<dim>&, const Eigen::VectorXd& p, NodeVectors<dim>& forces) const;
  void add_tangent(const FlagStep<dim>&, const Eigen::VectorXd& p, TangentMatrix<dim>&) const;

 private:
  static constexpr std::size_t corners = dim == 2 ? 2 : 4;
  using Vector = Eigen::Matrix<double, dim, 1>;
  struct Element {
    std::array<int, corners> nodes;  // two: from, to; four: 00, 01, 10, 11
    bool crosses_seam;
  };

  double span_;
  std::vector<Element> elements_;
};

}  // namespace pennon::dns

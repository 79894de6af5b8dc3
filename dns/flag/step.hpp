/// What the forces of a flag over one step depend on.
#pragma once

#include <Eigen/Core>

#include "dns/flag/mesh.hpp"

namespace pennon::dns {

/// A vector for each node, dim x nodes: (x, y, z), in two dimensions (y, z).
template <int dim>
using NodeVectors = Eigen::Matrix<double, dim, Eigen::Dynamic>;

/// The flat flag without stress.
template <int dim>
NodeVectors<dim> rest(const FlagMesh& mesh) {
  NodeVectors<dim> x = NodeVectors<dim>::Zero(dim, mesh.nodes());
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j) {
      x(dim - 2, mesh.index(i, j)) = mesh.y(j);
      if constexpr (dim == 3) x(0, mesh.index(i, j)) = mesh.x(i);
    }
  return x;
}

/// Where forces are taken between the start and the end of a step.
enum class Pairing {
  /// At the end: the forces are the gradient of the energy there. For statics and backward
  /// differences.
  end,
  /// A discrete gradient between start and end: the work of the forces over the step is exactly the
  /// change of the energy, and momentum and angular momentum stay exactly. Each length, strain and
  /// difference vector is replaced by the mean of its two values.
  discrete_gradient
};

template <int dim>
struct FlagStep {
  const NodeVectors<dim>& start;
  const NodeVectors<dim>& end;
  Pairing pairing = Pairing::end;
  /// For the damping. With Pairing::discrete_gradient the strain rate is that over the step,
  /// (strain at end - strain at start)/dt; 0: no damping.
  double dt = 0;
  /// With Pairing::end it is that of the velocity at the end, which follows the end position by
  /// d(velocity)/d(end) = velocity_factor; null: no damping.
  const NodeVectors<dim>* velocity = nullptr;
  double velocity_factor = 0;

  /// How fast the means follow the end: d(mean)/d(end).
  double share_of_end() const { return pairing == Pairing::end ? 1.0 : 0.5; }
};

}  // namespace pennon::dns

/// Inertia that a fluid adds to a flag, as the flag's own equations see it: a symmetric operator
/// M_a from the accelerations of the nodes to forces on them.
#pragma once

#include "dns/flag/step.hpp"
#include "dns/flag/tangent_matrix.hpp"

namespace pennon::dns {

template <int dim>
class AddedInertia {
 public:
  virtual ~AddedInertia() = default;

  /// Subtracts M_a a from the forces on the nodes.
  virtual void subtract_force(const NodeVectors<dim>& acceleration,
                              NodeVectors<dim>& forces) const = 0;

  /// Solves (K + mass_factor M_a) x = r in place, K with factors of its own or of an earlier
  /// tangent. Returns the iterations.
  virtual int solve(TangentMatrix<dim>& K, double mass_factor, NodeVectors<dim>& r) = 0;

 protected:
  AddedInertia() = default;
  AddedInertia(const AddedInertia&) = default;
  AddedInertia& operator=(const AddedInertia&) = default;
  AddedInertia(AddedInertia&&) noexcept = default;
  AddedInertia& operator=(AddedInertia&&) noexcept = default;
};

}  // namespace pennon::dns

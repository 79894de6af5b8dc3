/// The discrete flag: mass, stretch, bending, gravity and loads, with their energies, forces and
/// exact tangent (Banerjee, Connell & Yue 2015, section 3.2). docs/theory/flag.md derives it. A
/// term that a case does not have is not computed.
///
/// dim = 2: the flag in two dimensions, components (y, z), per unit span. dim = 3: (x, y, z).
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dns/flag/bending_form.hpp"
#include "dns/flag/held_nodes.hpp"
#include "dns/flag/material.hpp"
#include "dns/flag/mesh.hpp"
#include "dns/flag/pressure_load.hpp"
#include "dns/flag/step.hpp"
#include "dns/flag/stretch.hpp"
#include "dns/flag/tangent_matrix.hpp"

namespace pennon::dns {

/// What acts on the flag from outside.
template <int dim>
struct FlagLoads {
  Eigen::Matrix<double, dim, 1> gravity = Eigen::Matrix<double, dim, 1>::Zero();  ///< g L/V^2
  Eigen::VectorXd pressure;      ///< jump of each element, in rho_f V^2; empty: none
  NodeVectors<dim> node_forces;  ///< that keep their direction, in rho_f V^2 L^2; empty: none
};

/// The energies of section 3.2, in rho_f V^2 L^3 (per unit span: rho_f V^2 L^2).
struct FlagEnergies {
  double kinetic = 0;
  double bending = 0;
  double stretch_2d = 0;  ///< of the chordwise strain alone
  double stretch_3d = 0;  ///< what the span adds
  double gravity = 0;     ///< - sum m g.x, zero at the origin

  double total() const { return kinetic + bending + stretch_2d + stretch_3d + gravity; }
};

template <int dim>
class Flag {
 public:
  Flag(FlagMesh mesh, const FlagMaterial& material);

  const FlagMesh& mesh() const { return mesh_; }
  const FlagMaterial& material() const { return material_; }
  /// mu times the area of each node.
  const Eigen::VectorXd& mass() const { return mass_; }
  /// Sets the vectors of the held nodes to zero.
  void clear_held(NodeVectors<dim>& vectors) const { held_.clear(vectors); }
  int elements() const { return pressure_.elements(); }
  const Stretch<dim>& stretch() const { return stretch_; }

  /// The flat flag without stress, dim x nodes.
  NodeVectors<dim> rest() const { return dns::rest<dim>(mesh_); }
  /// A matrix with the pattern of the tangent.
  std::unique_ptr<TangentMatrix<dim>> tangent_matrix() const;

  FlagEnergies energies(const NodeVectors<dim>& x, const NodeVectors<dim>& v,
                        const FlagLoads<dim>&) const;

  /// Internal forces and loads over a step, held nodes included (there it is what the support
  /// bears).
  NodeVectors<dim> forces(const FlagStep<dim>&, const FlagLoads<dim>&) const;
  /// The same into `forces`, dim x nodes, without allocating.
  void evaluate_forces(const FlagStep<dim>&, const FlagLoads<dim>&, NodeVectors<dim>& forces) const;
  /// The loads alone, gravity left out: what does work on the flag.
  NodeVectors<dim> load_forces(const FlagStep<dim>&, const FlagLoads<dim>&) const;
  void evaluate_load_forces(const FlagStep<dim>&, const FlagLoads<dim>&,
                            NodeVectors<dim>& forces) const;
  /// Adds the derivative of minus these forces by step.end, and mass_factor times the mass.
  void add_tangent(const FlagStep<dim>&, const FlagLoads<dim>&, double mass_factor,
                   TangentMatrix<dim>&) const;

 private:
  bool bends() const { return material_.bending().stiffness > 0; }

  FlagMesh mesh_;
  FlagMaterial material_;
  Stretch<dim> stretch_;
  BendingForm bending_;
  NodeVectors<dim> bending_load_;
  PressureLoad<dim> pressure_;
  Eigen::VectorXd mass_;
  HeldNodes held_;
};

}  // namespace pennon::dns

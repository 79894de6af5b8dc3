/// The bending energy of section 3.2 on the nodes of a flag: the plate energy of Kirchhoff,
///
///   E_b = K_B/2 int int |x_11|^2 + |x_22|^2 + 2 nu_s x_11.x_22 + 2 (1 - nu_s) |x_12|^2 ds_1 ds_2,
///
/// whose gradient is the bending term of (3.3), (3.4) inside and whose natural conditions hold at
/// the edges: x_11 + nu_s x_22 = 0, x_111 + (2 - nu_s) x_122 = 0 on a free edge s_1 = 1. x_1 stands
/// for dx/ds_1. It is quadratic in the positions, so the forces are linear and the tangent
/// constant.
///
/// Discrete: x_11 and x_22 at the nodes (three points), x_12 at the cells (four points); second
/// order where the chordwise spacing varies smoothly. At a clamped edge the held slope takes the
/// place of the missing neighbour. At a free or pinned edge the curvature across it is not known
/// from the nodes: it takes the value that makes the energy least, x_11 = -nu_s x_22, which is the
/// natural condition.
#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "dns/flag/material.hpp"
#include "dns/flag/mesh.hpp"

namespace pennon::dns {

/// A vector that depends linearly on the positions: the sum of weight x_node, and a constant.
struct LinearVector {
  struct Term {
    int node;
    double weight;
  };
  std::vector<Term> terms;
  Eigen::Vector3d constant = Eigen::Vector3d::Zero();
};

/// E_b = 1/2 sum_pq stiffness_pq x_p.x_q + sum_p load_p.x_p + constant; the components are (x, y,
/// z).
struct BendingForm {
  Eigen::SparseMatrix<double> stiffness;  ///< nodes x nodes, symmetric
  Eigen::Matrix3Xd load;                  ///< 3 x nodes; of held slopes and of the period

  /// The same energy as a sum of weight a.b over curvatures. Its value is found from this sum, in
  /// which the large terms of the quadratic form do not cancel.
  struct Product {
    double weight;
    LinearVector a, b;
  };
  std::vector<Product> products;
  /// `x`: 3 x nodes.
  double energy(const Eigen::Matrix3Xd& x) const;
};

/// In two dimensions only the stiffness along the chord enters.
BendingForm bending_form(const FlagMesh&, const BendingEnergy&);

}  // namespace pennon::dns

/// The fluid's part of the linearised equations of flow and flag (coupled_operator.hpp), for one
/// spanwise wavenumber k_x: what a small disturbance of the steady flow and a small motion of the
/// flag do to the flow, and the force of both on the flag. It depends on the steady flow and the
/// grid, and on nothing of the flag but where its nodes are.
///
/// With q_v the flow's unknowns and zeta, zeta_t = d zeta/dt those of the flag's free nodes,
///
///   lambda B_vv q_v = A_vv q_v + A_vz zeta + A_vt zeta_t       (momentum and continuity)
///   force           = A_tv q_v + F_z zeta + F_t zeta_t         (along z, per unit span)
///
/// The first index is the row of equations, the second the unknown: v the flow, z zeta, t zeta_t.
/// B_vv is the diagonal of the cells' volumes, 0 for the pressure. A_vv is minus the Jacobian
/// (jacobian.hpp) of the flow's equations. A_vz = A_vd G and A_vt = A_vg G: the corners of the grid
/// follow the flag by G (grid_response.hpp), and the sparse A_vd and A_vg are minus the derivatives
/// of the flow's equations by the displacement (d) and by the velocity (g) of the corners. Their
/// products with G are dense and are not kept.
#pragma once

#include <Eigen/SparseCore>
#include <complex>

#include "modes/global/equations/base_flow.hpp"
#include "modes/global/equations/grid_response.hpp"

namespace pennon::modes::global {

struct LinearFluid {
  using Sparse = Eigen::SparseMatrix<std::complex<double>>;
  using SparseRows = Eigen::SparseMatrix<std::complex<double>, Eigen::RowMajor>;

  HalfPlane flow;           ///< q_v: velocity and pressure of the upper half plane
  Eigen::Index flag_nodes;  ///< those that are free, from the leading edge
  /// Whether conj(lambda) is an eigenvalue where lambda is: without a cross-flow, or with no wave
  /// along the span.
  bool is_symmetric = true;
  Sparse A_vv = {}, B_vv = {};          ///< flow x flow
  Sparse A_tv = {};                     ///< nodes x flow
  Eigen::MatrixXcd F_z = {}, F_t = {};  ///< nodes x nodes
  SparseRows A_vd = {}, A_vg = {};      ///< flow x moving corners
  Eigen::MatrixXd G = {};               ///< moving corners x nodes

  /// G zeta, the displacement of the moving corners.
  Eigen::VectorXcd corners(const Eigen::VectorXcd& zeta) const;
  /// Products of A_vz and A_vt with a vector for the flag's nodes, and of their adjoints with one
  /// for the flow's unknowns.
  Eigen::VectorXcd A_vz(const Eigen::VectorXcd& zeta) const;
  Eigen::VectorXcd A_vt(const Eigen::VectorXcd& zeta_t) const;
  Eigen::VectorXcd A_vz_adjoint(const Eigen::VectorXcd& p) const;
  Eigen::VectorXcd A_vt_adjoint(const Eigen::VectorXcd& p) const;

  /// A_vz + lambda A_vt, with which a motion zeta exp(lambda t) of the flag forces the flow: its
  /// columns first .. first + count - 1.
  Eigen::MatrixXcd flag_forcing(std::complex<double> lambda, Eigen::Index first,
                                Eigen::Index count) const;
};

/// `base` has as many components of the velocity as the disturbance: 3 where k_x is not 0. The last
/// `nodes` of the flag's nodes are free.
LinearFluid linear_fluid(const OGrid&, const BaseFlow& base, int nodes, double k_x);

}  // namespace pennon::modes::global

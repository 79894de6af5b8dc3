/// The fluid's part of the linearised equations of flow and flag, for one spanwise wavenumber k_x:
/// what a small disturbance of the steady flow and a small motion of the flag do to the flow, and
/// the force of both on the flag. It knows the steady flow and the grid, nothing of the flag but
/// where its nodes are.
///
/// With v the flow's unknowns, zeta and eta = d zeta/dt those of the flag's free nodes,
///
///   lambda B_vv v = A_vv v + (D_z zeta + D_e eta)                (momentum, continuity)
///   force         = A_ev v + F_z zeta + F_e eta
///
/// D_z = D_d G and D_e = D_t G: the grid follows the flag by G (grid_response.hpp), and the
/// equations change with its corners' displacement and velocity by the sparse D_d and D_t. Their
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

  HalfPlane flow;           ///< v: velocity and pressure of the upper half plane
  Eigen::Index flag_nodes;  ///< those that are free, from the leading edge
  /// Whether conj(lambda) is an eigenvalue where lambda is: without a cross-flow, or with no wave
  /// along the span.
  bool is_symmetric = true;
  Sparse A_vv = {}, B_vv = {};          ///< flow x flow
  Sparse A_ev = {};                     ///< nodes x flow
  Eigen::MatrixXcd F_z = {}, F_e = {};  ///< nodes x nodes
  SparseRows D_d = {}, D_t = {};        ///< flow x moving corners
  Eigen::MatrixXd G = {};               ///< moving corners x nodes

  /// G zeta.
  Eigen::VectorXcd corners(const Eigen::VectorXcd& zeta) const;
  Eigen::VectorXcd D_z(const Eigen::VectorXcd& zeta) const;
  Eigen::VectorXcd D_e(const Eigen::VectorXcd& eta) const;
  Eigen::VectorXcd D_z_adjoint(const Eigen::VectorXcd& p) const;
  Eigen::VectorXcd D_e_adjoint(const Eigen::VectorXcd& p) const;

  /// D_z + lambda D_e: columns first .. first + count - 1.
  Eigen::MatrixXcd motion(std::complex<double> lambda, Eigen::Index first,
                          Eigen::Index count) const;
};

/// `base` has as many components of the velocity as the disturbance: 3 where k_x is not 0. The last
/// `nodes` of the flag's nodes are free.
LinearFluid linear_fluid(const OGrid&, const BaseFlow& base, int nodes, double k_x);

}  // namespace pennon::modes::global

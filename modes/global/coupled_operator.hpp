/// The coupled linearised equations of flow and flag for one spanwise wavenumber k_x,
///
///   A q = lambda B q,     q = (v, p of the upper half plane; zeta; d zeta/dt),
///
/// about the steady flow past the flat flag: disturbances q exp(i k_x x + lambda t), antisymmetric
/// about the plane of the flag. The velocities are those at points that move with the grid, which
/// follows the flag:
///
///   lambda V v        = - J v - R_d G zeta - R_g G zeta'      (momentum)
///   0                 = the same of the continuity
///   lambda zeta       = zeta'
///   lambda M zeta'    = - K zeta + F v + F_d G zeta + F_g G zeta'
///
/// J the Jacobian of the flow, G the answer of the grid to the flag, R_d and R_g the derivatives of
/// the equations by the grid's displacement and velocity, F those of the force. B is singular:
/// continuity has no time derivative.
#pragma once

#include <Eigen/SparseCore>
#include <complex>

#include "modes/global/base_flow.hpp"
#include "modes/global/flag_operator.hpp"

namespace pennon::modes::global {

struct CoupledOperator {
  Eigen::SparseMatrix<std::complex<double>> A, B;
  HalfPlane flow;           ///< the first unknowns
  Eigen::Index flag_nodes;  ///< then this many zeta, as many d zeta/dt, from the leading edge

  Eigen::Index zeta(Eigen::Index node) const { return flow.unknowns() + node; }
  Eigen::Index zeta_t(Eigen::Index node) const { return flow.unknowns() + flag_nodes + node; }
};

/// `base` has as many components of the velocity as the disturbance: 3 where k_x is not 0.
CoupledOperator coupled_operator(const OGrid&, const BaseFlow& base, const FlagOperator&,
                                 double k_x);

}  // namespace pennon::modes::global

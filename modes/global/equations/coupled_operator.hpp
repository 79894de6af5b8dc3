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
/// the equations by the grid's displacement and velocity, F those of the force: all that is
/// LinearFluid's. B is singular: continuity has no time derivative.
#pragma once

#include <memory>

#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/equations/linear_fluid.hpp"
#include "modes/global/equations/pencil.hpp"

namespace pennon::modes::global {

/// Copies share the fluid's part.
class CoupledOperator final : public Pencil {
 public:
  CoupledOperator(std::shared_ptr<const LinearFluid> its_fluid, FlagOperator its_flag)
      : flag(std::move(its_flag)), fluid_(std::move(its_fluid)) {}

  FlagOperator flag;

  const LinearFluid& fluid() const { return *fluid_; }
  const std::shared_ptr<const LinearFluid>& shared_fluid() const { return fluid_; }

  // The unknowns: the flow's, then as many zeta as the flag has free nodes, from the leading edge,
  // then as many d zeta/dt.
  const HalfPlane& flow() const { return fluid_->flow; }
  Eigen::Index flag_nodes() const { return fluid_->flag_nodes; }
  Eigen::Index zeta(Eigen::Index node) const { return flow().unknowns() + node; }
  Eigen::Index zeta_t(Eigen::Index node) const { return flow().unknowns() + flag_nodes() + node; }

  Eigen::Index size() const override { return flow().unknowns() + 2 * flag_nodes(); }
  Eigen::VectorXcd A(const Eigen::VectorXcd& q) const override;
  Eigen::VectorXcd B(const Eigen::VectorXcd& q) const override;
  Eigen::VectorXcd A_adjoint(const Eigen::VectorXcd& p) const override;
  Eigen::VectorXcd B_adjoint(const Eigen::VectorXcd& p) const override;

  /// As matrices, of which A has 2 flag_nodes() dense columns.
  SparsePencil assembled() const;

 private:
  std::shared_ptr<const LinearFluid> fluid_;
};

/// `base` has as many components of the velocity as the disturbance: 3 where k_x is not 0.
CoupledOperator coupled_operator(const OGrid&, const BaseFlow& base, FlagOperator, double k_x);

}  // namespace pennon::modes::global

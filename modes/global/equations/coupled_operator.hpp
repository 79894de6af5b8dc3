/// The coupled linearised equations of flow and flag for one spanwise wavenumber k_x,
///
///   A q = lambda B q,     q = (q_v; zeta; zeta_t),
///
/// about the steady flow past the flat flag, for disturbances q exp(i k_x x + lambda t) that are
/// antisymmetric about the plane of the flag. q_v holds velocity and pressure in the cells of the
/// upper half plane (HalfPlane), at points that move with the grid, which follows the flag; zeta
/// and zeta_t = d zeta/dt are those of the flag's free nodes:
///
///   lambda B_vv q_v    = A_vv q_v + A_vz zeta + A_vt zeta_t            (momentum and continuity)
///   lambda zeta        = zeta_t
///   lambda M zeta_t    = A_tv q_v + (F_z - K) zeta + F_t zeta_t        (the flag's motion)
///
/// The matrices with the indices v, z and t and the forces F_z and F_t are LinearFluid's, M and K
/// are FlagOperator's. B is singular, since continuity has no time derivative.
#pragma once

#include <memory>

#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/equations/linear_fluid.hpp"
#include "modes/global/equations/pencil.hpp"

namespace pennon::modes::global {

/// The two matrices as their products with vectors of size() numbers. Copies share the fluid's
/// part.
class CoupledOperator final : public Pencil {
 public:
  CoupledOperator(std::shared_ptr<const LinearFluid> its_fluid, FlagOperator its_flag)
      : flag(std::move(its_flag)), fluid_(std::move(its_fluid)) {}

  FlagOperator flag;

  const LinearFluid& fluid() const { return *fluid_; }
  const std::shared_ptr<const LinearFluid>& shared_fluid() const { return fluid_; }

  /// How the unknowns are counted: first those of the flow, q_v, as flow() does; then zeta at the
  /// flag's free nodes, from the leading edge; then zeta_t at the same nodes.
  const HalfPlane& flow() const { return fluid_->flow; }
  Eigen::Index flag_nodes() const { return fluid_->flag_nodes; }
  Eigen::Index zeta(Eigen::Index node) const { return flow().unknowns() + node; }
  Eigen::Index zeta_t(Eigen::Index node) const { return flow().unknowns() + flag_nodes() + node; }

  Eigen::Index size() const override { return flow().unknowns() + 2 * flag_nodes(); }
  Eigen::VectorXcd A(const Eigen::VectorXcd& q) const override;
  Eigen::VectorXcd B(const Eigen::VectorXcd& q) const override;
  Eigen::VectorXcd A_adjoint(const Eigen::VectorXcd& p) const override;
  Eigen::VectorXcd B_adjoint(const Eigen::VectorXcd& p) const override;

  /// The same as sparse matrices; A has 2 flag_nodes() dense columns.
  SparsePencil assembled() const;

 private:
  std::shared_ptr<const LinearFluid> fluid_;
};

/// The operator about the steady flow `base`, which has as many components of the velocity as the
/// disturbance: 3 where k_x is not 0.
CoupledOperator coupled_operator(const OGrid&, const BaseFlow& base, FlagOperator, double k_x);

}  // namespace pennon::modes::global

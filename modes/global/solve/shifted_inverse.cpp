#include "modes/global/solve/shifted_inverse.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

}  // namespace

ShiftedSparse::ShiftedSparse(const SparsePencil& pencil, Complex target,
                             std::shared_ptr<SparseFactors> factors)
    : factors_(std::move(factors)) {
  factors_->factor(pencil.matrix_A - target * pencil.matrix_B);
}

Eigen::VectorXcd ShiftedSparse::solve(const Eigen::VectorXcd& b) const {
  return factors_->solve(b);
}

Eigen::VectorXcd ShiftedSparse::solve_adjoint(const Eigen::VectorXcd& c) const {
  return factors_->solve_adjoint(c);
}

ShiftedCoupled::ShiftedCoupled(const CoupledOperator& coupled, Complex target,
                               std::shared_ptr<SparseFactors> factors)
    : coupled_(coupled), target_(target), response_(coupled.shared_fluid(), std::move(factors)) {
  by_velocity_ = coupled.fluid().F_t;
  by_velocity_.diagonal() -= target * coupled.flag.mass;
  Eigen::MatrixXcd S = response_.at(target) - coupled.flag.stiffness;
  S.diagonal() -= target * target * coupled.flag.mass;
  complement_.compute(S);
  adjoint_complement_.compute(S.adjoint());
}

Eigen::VectorXcd ShiftedCoupled::solve(const Eigen::VectorXcd& b) const {
  const LinearFluid& f = coupled_.fluid();
  const Eigen::Index n = f.flow.unknowns(), m = f.flag_nodes;
  const Eigen::VectorXcd b_z = b.segment(n, m);
  const Eigen::VectorXcd w = response_.factors().solve(b.head(n) - f.A_vt(b_z));
  const Eigen::VectorXcd zeta = complement_.solve(b.tail(m) - f.A_tv * w - by_velocity_ * b_z);
  Eigen::VectorXcd q(b.size());
  q << w + response_.flow_response() * zeta, zeta, target_ * zeta + b_z;
  return q;
}

Eigen::VectorXcd ShiftedCoupled::solve_adjoint(const Eigen::VectorXcd& c) const {
  const LinearFluid& f = coupled_.fluid();
  const Eigen::Index n = f.flow.unknowns(), m = f.flag_nodes;
  const Eigen::VectorXcd c_v = c.head(n), c_t = c.tail(m);
  const Eigen::VectorXcd p_t = adjoint_complement_.solve(
      c.segment(n, m) + std::conj(target_) * c_t + response_.flow_response().adjoint() * c_v);
  const Eigen::VectorXcd p_v = response_.factors().solve_adjoint(c_v - f.A_tv.adjoint() * p_t);
  Eigen::VectorXcd p(c.size());
  p << p_v, c_t - f.A_vt_adjoint(p_v) - by_velocity_.adjoint() * p_t, p_t;
  return p;
}

}  // namespace pennon::modes::global

#include "modes/global/aerodynamic_matrix.hpp"

#include <fmt/format.h>

#include <Eigen/UmfPackSupport>

#include "common/errors.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Sparse = Eigen::SparseMatrix<Complex>;

}  // namespace

struct AerodynamicMatrix::Parts {
  Sparse A_vv, B_vv, A_vz, A_ve, A_ev, F_dt;
  Eigen::MatrixXcd F_d;
  Complex lambda;
  Sparse shifted;  // the factors refer to it
  Eigen::UmfPackLU<Sparse> factors;
  Eigen::MatrixXcd v;  // of each node's motion
  bool has_pattern = false;

  Parts(const CoupledOperator& coupled, const Eigen::MatrixXcd& stiffness) {
    const Eigen::Index flow = coupled.flow.unknowns(), nodes = coupled.flag_nodes;
    const Eigen::Index z = coupled.zeta(0), e = coupled.zeta_t(0);
    A_vv = coupled.A.block(0, 0, flow, flow);
    B_vv = coupled.B.block(0, 0, flow, flow);
    A_vz = coupled.A.block(0, z, flow, nodes);
    A_ve = coupled.A.block(0, e, flow, nodes);
    A_ev = coupled.A.block(e, 0, nodes, flow);
    F_dt = coupled.A.block(e, e, nodes, nodes);
    F_d = Eigen::MatrixXcd(coupled.A.block(e, z, nodes, nodes)) + stiffness;
    // The solutions are good to rounding as they are, and three times as fast without refinement.
    factors.umfpackControl()(UMFPACK_IRSTEP) = 0;
  }

  void factor(Complex at) {
    lambda = at;
    shifted = A_vv - lambda * B_vv;
    // An entry of A that lambda B cancels stays in the pattern.
    if (!has_pattern) factors.analyzePattern(shifted);
    has_pattern = true;
    factors.factorize(shifted);
    if (factors.info() != Eigen::Success)
      throw SolverError(
          fmt::format("the flow's response at lambda = {:.6g} {:+.6g} i could not be found: the "
                      "flow past the flag at rest has an eigenvalue there",
                      lambda.real(), lambda.imag()));
  }
};

AerodynamicMatrix::AerodynamicMatrix(const CoupledOperator& coupled,
                                     const Eigen::MatrixXcd& stiffness)
    : parts_(std::make_unique<Parts>(coupled, stiffness)) {}
AerodynamicMatrix::~AerodynamicMatrix() = default;
AerodynamicMatrix::AerodynamicMatrix(AerodynamicMatrix&&) noexcept = default;
AerodynamicMatrix& AerodynamicMatrix::operator=(AerodynamicMatrix&&) noexcept = default;

Eigen::Index AerodynamicMatrix::flag_nodes() const {
  return parts_->F_d.rows();
}

Eigen::MatrixXcd AerodynamicMatrix::at(Complex lambda) {
  Parts& p = *parts_;
  p.factor(lambda);
  const Eigen::MatrixXcd motion = -Eigen::MatrixXcd(p.A_vz + lambda * p.A_ve);
  p.v = p.factors.solve(motion);
  return p.A_ev * p.v + p.F_d + lambda * Eigen::MatrixXcd(p.F_dt);
}

Eigen::VectorXcd AerodynamicMatrix::derivative(const Eigen::VectorXcd& zeta) {
  Parts& p = *parts_;
  const Eigen::VectorXcd flow = p.v * zeta, right = p.B_vv * flow - p.A_ve * zeta;
  const Eigen::VectorXcd change = p.factors.solve(right);
  return p.A_ev * change + p.F_dt * zeta;
}

Eigen::VectorXcd AerodynamicMatrix::mode(const Eigen::VectorXcd& zeta) const {
  const Parts& p = *parts_;
  Eigen::VectorXcd q(p.v.rows() + 2 * zeta.size());
  q << p.v * zeta, zeta, p.lambda * zeta;
  return q;
}

}  // namespace pennon::modes::global

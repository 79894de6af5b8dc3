#include "modes/global/solve/aerodynamic_matrix.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "common/errors.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr Eigen::Index columns_in_turn = 64;  // that are solved together

}  // namespace

AerodynamicMatrix::AerodynamicMatrix(std::shared_ptr<const LinearFluid> fluid,
                                     std::shared_ptr<SparseFactors> factors)
    : fluid_(std::move(fluid)), factors_(std::move(factors)) {}

Eigen::MatrixXcd AerodynamicMatrix::at(Complex lambda) try {
  const LinearFluid& f = *fluid_;
  lambda_ = lambda;
  // An entry of A that lambda B cancels stays in the pattern.
  factors_->factor(f.A_vv - lambda * f.B_vv);
  X_.resize(f.flow.unknowns(), f.flag_nodes);
  for (Eigen::Index first = 0; first < f.flag_nodes; first += columns_in_turn) {
    const Eigen::Index count = std::min(columns_in_turn, f.flag_nodes - first);
    X_.middleCols(first, count) = factors_->solve(-f.flag_forcing(lambda, first, count));
  }
  return f.A_tv * X_ + f.F_z + lambda * f.F_t;
} catch (const SolverError& fault) {
  throw SolverError(
      fmt::format("the flow's response at lambda = {:.6g} {:+.6g} i could not be found: {}",
                  lambda.real(), lambda.imag(), fault.what()));
}

Eigen::VectorXcd AerodynamicMatrix::derivative(const Eigen::VectorXcd& zeta) {
  const LinearFluid& f = *fluid_;
  const Eigen::VectorXcd flow = X_ * zeta, right = f.B_vv * flow - f.A_vt(zeta);
  return f.A_tv * factors_->solve(right) + f.F_t * zeta;
}

Eigen::VectorXcd AerodynamicMatrix::mode(const Eigen::VectorXcd& zeta) const {
  Eigen::VectorXcd q(X_.rows() + 2 * zeta.size());
  q << X_ * zeta, zeta, lambda_ * zeta;
  return q;
}

}  // namespace pennon::modes::global

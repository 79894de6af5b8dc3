#include "analysis/decomposition/variable_projection.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <complex>

#include "common/errors.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

// The projection for one set of lambda.
class Projection {
 public:
  Projection(const MatrixXcd& Z, const VectorXd& t, const VectorXcd& lambda) : t_(t) {
    // Each exponential is 1 where it is largest, so that none overflows; its span is the same.
    Phi_.resize(t.size(), lambda.size());
    for (Index j = 0; j < lambda.size(); ++j) {
      const double largest_at = lambda(j).real() > 0 ? t(t.size() - 1) : t(0);
      Phi_.col(j) = ((t.array() - largest_at) * lambda(j)).exp();
    }
    const Eigen::HouseholderQR<MatrixXcd> factors(Phi_);
    Q_ = factors.householderQ() * MatrixXcd::Identity(t.size(), lambda.size());
    const MatrixXcd QZ = Q_.adjoint() * Z;
    B_ = factors.matrixQR().topRows(lambda.size()).triangularView<Eigen::Upper>().solve(QZ);
    rest_ = Z - Q_ * QZ;
  }

  double misfit_squared() const { return rest_.squaredNorm(); }
  bool is_finite() const { return B_.allFinite() && rest_.allFinite(); }
  // The columns (1 - Q Q^*) t phi_j.
  MatrixXcd tangents() const {
    const MatrixXcd t_Phi = t_.asDiagonal() * Phi_;
    return t_Phi - Q_ * (Q_.adjoint() * t_Phi);
  }
  const MatrixXcd& B() const { return B_; }
  const MatrixXcd& rest() const { return rest_; }

 private:
  VectorXd t_;
  MatrixXcd Phi_, Q_, B_, rest_;
};

// The normal equations N delta = g of the linearised misfit.
struct NormalEquations {
  MatrixXcd D, N;
  VectorXcd g;

  explicit NormalEquations(const Projection& at) : D(at.tangents()) {
    const MatrixXcd& B = at.B();
    N = (D.adjoint() * D).cwiseProduct(B.conjugate() * B.transpose());
    g = (D.adjoint() * at.rest()).cwiseProduct(B.conjugate()).rowwise().sum();
  }
};

// See the header; `rank` is that of the fit.
void set_variances(const Projection& at, bool is_real, ExponentialFit& fit) {
  const NormalEquations equations(at);
  const MatrixXcd inverse = equations.N.fullPivLu().inverse();
  fit.variance = inverse.diagonal().real();
  fit.pseudo_variance = VectorXcd::Zero(fit.lambda.size());
  if (!is_real) return;
  // delta_j = sum_k N^-1_jk sum_mc conj(B_kc D_mk) e_mc, with real e of unit variance.
  const MatrixXcd D = equations.D.conjugate(), B = at.B().conjugate();
  const MatrixXcd squares = (D.transpose() * D).cwiseProduct(B * B.transpose());
  fit.pseudo_variance = (inverse * squares * inverse.transpose()).diagonal();
}

}  // namespace

ExponentialFit fit_exponentials(const MatrixXcd& Z, const std::vector<double>& times,
                                VectorXcd lambda, bool is_real) {
  constexpr int most_iterations = 400;
  constexpr double small_step = 1e-11, tiny_gain = 1e-14, least_damping = 1e-12, most_damping = 1e8;
  const VectorXd t =
      (Eigen::Map<const VectorXd>(times.data(), static_cast<Index>(times.size())).array() -
       times.front())
          .matrix();
  const double duration = t(t.size() - 1);
  const auto size_of = [&](const VectorXcd& step) {
    return (step.array().abs() / (lambda.array().abs() + 1 / duration)).maxCoeff();
  };
  Projection at(Z, t, lambda);
  double damping = 1e-3;
  int small_gains = 0;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    const NormalEquations equations(at);
    bool is_better = false;
    double step_size = 0, gain = 0;
    while (!is_better && damping < most_damping) {
      MatrixXcd damped = equations.N;
      damped.diagonal() *= 1 + damping;
      const VectorXcd step = damped.ldlt().solve(equations.g);
      if (!step.allFinite()) break;
      const VectorXcd next = lambda + step;
      Projection there(Z, t, next);
      step_size = size_of(step);
      is_better = there.is_finite() && there.misfit_squared() < at.misfit_squared();
      if (is_better) {
        gain = 1 - there.misfit_squared() / at.misfit_squared();
        lambda = next;
        at = std::move(there);
        damping = std::max(damping / 5, least_damping);
      } else {
        if (step_size < small_step) break;
        damping *= 4;
      }
    }
    small_gains = gain < tiny_gain ? small_gains + 1 : 0;
    if (!is_better || step_size < small_step || small_gains == 3) {
      ExponentialFit fit{lambda, {}, at.misfit_squared(), {}, {}, iteration};
      fit.Phi = ((t * lambda.transpose()).array()).exp();
      set_variances(at, is_real, fit);
      return fit;
    }
  }
  throw SolverError(fmt::format(
      "the fit of {} exponentials to {} snapshots did not converge in {} iterations; with fewer "
      "(decompose.rank), or the exact variant (decompose.variant), it may",
      lambda.size(), t.size(), most_iterations));
}

}  // namespace pennon::decomposition

#include "analysis/decomposition/variable_projection.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <Eigen/QR>
#include <cmath>
#include <complex>

#include "common/errors.hpp"
#include "common/interrupt.hpp"

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
    const VectorXd size = Phi_.colwise().norm();
    const Eigen::HouseholderQR<MatrixXcd> factors(Phi_);
    const auto R = factors.matrixQR().topRows(lambda.size());
    // Two exponentials that cannot be told apart make amplitudes without bound.
    constexpr double inseparable = 1e-9;
    is_separate_ =
        size.allFinite() && (R.diagonal().cwiseAbs().array() > inseparable * size.array()).all();
    if (!is_separate_) return;
    Q_ = factors.householderQ() * MatrixXcd::Identity(t.size(), lambda.size());
    const MatrixXcd QZ = Q_.adjoint() * Z;
    B_ = R.triangularView<Eigen::Upper>().solve(QZ);
    rest_ = Z - Q_ * QZ;
  }

  /// Whether the exponentials are linearly independent at these times; else there is nothing else.
  bool is_separate() const { return is_separate_; }
  double misfit_squared() const { return rest_.squaredNorm(); }
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
  bool is_separate_ = false;
};

// Real signals have exponentials in conjugate pairs, and real ones; those that change their sign at
// each time step count as real.
class Pairs {
 public:
  Pairs(const VectorXcd& lambda, bool is_real)
      : partner_(static_cast<std::size_t>(lambda.size()), none) {
    if (!is_real) return;
    fixed_ = lambda.imag();
    for (Index j = 0; j < lambda.size(); ++j) {
      if (partner_[static_cast<std::size_t>(j)] != none) continue;
      Index nearest = j;
      for (Index k = j + 1; k < lambda.size(); ++k) {
        const bool is_free = partner_[static_cast<std::size_t>(k)] == none;
        const Complex opposite = std::conj(lambda(j));
        const double reach =
            nearest == j ? std::abs(lambda(j).imag()) : std::abs(lambda(nearest) - opposite);
        if (is_free && std::abs(lambda(k) - opposite) < reach) nearest = k;
      }
      partner_[static_cast<std::size_t>(j)] = nearest;
      partner_[static_cast<std::size_t>(nearest)] = j;
    }
  }
  VectorXcd symmetric(const VectorXcd& lambda) const {
    VectorXcd result = lambda;
    for (Index j = 0; j < lambda.size(); ++j) {
      const Index k = partner_[static_cast<std::size_t>(j)];
      if (k == none) continue;
      result(j) =
          k == j ? Complex(lambda(j).real(), fixed_(j)) : (lambda(j) + std::conj(lambda(k))) / 2.0;
    }
    return result;
  }

 private:
  static constexpr Index none = -1;
  std::vector<Index> partner_;
  VectorXd fixed_;  // imaginary parts at the start: 0, or half the sampling rate
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
  // At the end the tangents must be at right angles to what is left, or nothing is left.
  constexpr double right_angle = 1e-4, nothing = 1e-12;
  const auto count = static_cast<Index>(times.size());
  const VectorXd t =
      (Eigen::Map<const VectorXd>(times.data(), count).array() - times.front()).matrix();
  const double duration = t(count - 1), dt = duration / static_cast<double>(count - 1);
  // Beyond, an exponential is gone after one step, or its amplitude at the first time is no number.
  const double least_growth = std::log(1e-8) / dt, most_growth = std::log(1e150) / duration;
  const auto is_within = [&](const VectorXcd& each) {
    return each.allFinite() && (each.real().array() >= least_growth).all() &&
           (each.real().array() <= most_growth).all();
  };
  const auto fail = [&](const std::string& why) {
    throw SolverError(fmt::format(
        "the fit of {} exponentials to {} snapshots {}; with fewer (decompose.rank), or the exact "
        "variant (decompose.variant), there may be one",
        lambda.size(), count, why));
  };
  const auto size_of = [&](const VectorXcd& step) {
    return (step.array().abs() / (lambda.array().abs() + 1 / duration)).maxCoeff();
  };
  const Pairs pairs(lambda, is_real);
  lambda = pairs.symmetric(lambda);
  Projection at(Z, t, lambda);
  if (!is_within(lambda) || !at.is_separate())
    fail("cannot begin: two of them are the same to rounding");
  double damping = 1e-3;
  int small_gains = 0;
  for (int iteration = 1; iteration <= most_iterations; ++iteration) {
    stop_if_interrupted("nothing was written");
    const NormalEquations equations(at);
    bool is_better = false;
    double step_size = 0, gain = 0;
    while (!is_better && damping < most_damping) {
      MatrixXcd damped = equations.N;
      damped.diagonal() *= 1 + damping;
      const VectorXcd step = damped.ldlt().solve(equations.g);
      const VectorXcd next = pairs.symmetric(lambda + step);
      step_size = step.allFinite() ? size_of(step) : 1;
      if (is_within(next)) {
        Projection there(Z, t, next);
        is_better = there.is_separate() && there.misfit_squared() < at.misfit_squared();
        if (is_better) {
          gain = 1 - there.misfit_squared() / at.misfit_squared();
          lambda = next;
          at = std::move(there);
          damping = std::max(damping / 5, least_damping);
        }
      }
      if (!is_better) {
        if (step_size < small_step) break;
        damping *= 4;
      }
    }
    small_gains = gain < tiny_gain ? small_gains + 1 : 0;
    if (is_better && step_size >= small_step && small_gains < 3) continue;
    const NormalEquations last(at);
    const VectorXd angle = last.g.cwiseAbs().cwiseQuotient(
        (last.N.diagonal().real().cwiseSqrt() * at.rest().norm()).cwiseMax(1e-300));
    if (at.rest().norm() > nothing * Z.norm() && angle.maxCoeff() > right_angle)
      fail("came to an end before its least misfit");
    ExponentialFit fit{lambda, {}, at.misfit_squared(), {}, {}, iteration};
    fit.Phi = ((t * lambda.transpose()).array()).exp();
    set_variances(at, is_real, fit);
    return fit;
  }
  fail(fmt::format("did not converge in {} iterations", most_iterations));
  return {};
}

}  // namespace pennon::decomposition

#include "modes/global/neutral/flag_mode.hpp"

#include <Eigen/LU>
#include <cmath>

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Index = Eigen::Index;

// S and its derivatives at a mode, with the border.
class Bordered {
 public:
  Bordered(const Aerodynamics& F, const FlagOperator& flag, double mu, Complex lambda,
           const Eigen::VectorXcd& zeta, const Eigen::VectorXcd& border) {
    const Index n = zeta.size();
    const Response response = F(lambda);
    Eigen::MatrixXcd matrix(n + 1, n + 1);
    auto S = matrix.topLeftCorner(n, n);
    S = flag.stiffness - response.F;
    S.diagonal() += mu * lambda * lambda * flag.mass;
    inertia_ = lambda * lambda * flag.mass.cwiseProduct(zeta);
    residual_ = S * zeta;
    matrix.topRightCorner(n, 1) =
        2.0 * lambda * mu * flag.mass.cwiseProduct(zeta) - response.derivative(zeta);
    matrix.bottomLeftCorner(1, n) = border.adjoint();
    matrix(n, n) = 0;
    factors_.compute(matrix);
  }

  /// Changes of zeta and, last, lambda: of Newton's step, and with mu.
  Eigen::VectorXcd step() const { return solve(-residual_); }
  Eigen::VectorXcd by_mu() const { return solve(-inertia_); }
  /// psi with psi^H S = 0, psi^H S' zeta = 1: the last row of the inverse.
  Eigen::VectorXcd from_left() const {
    const Index n = residual_.size();
    const Eigen::VectorXcd last = Eigen::VectorXcd::Unit(n + 1, n);
    return Eigen::VectorXcd(factors_.adjoint().solve(last)).head(n);
  }

 private:
  Eigen::VectorXcd solve(const Eigen::VectorXcd& right) const {
    Eigen::VectorXcd whole(right.size() + 1);
    whole << right, 0.0;
    return factors_.solve(whole);
  }

  Eigen::VectorXcd inertia_, residual_;
  Eigen::PartialPivLU<Eigen::MatrixXcd> factors_;
};

struct Guess {
  Complex lambda;
  Eigen::VectorXcd zeta;
};

// The guess at the next mass ratio. Let h be the step before and s h the next one. lambda is
// extrapolated by the cubic through its values and slopes at -h and 0, zeta by the parabola through
// its values there and its slope at 0.
Guess expected(const std::optional<FollowedMode>& before, const FollowedMode& last, double mu) {
  const double step = mu - last.mu;
  const FlagMode& mode = last.mode;
  Guess guess{mode.lambda + mode.by_mu * step, mode.zeta};
  const bool has_slope = mode.shape_by_mu.size() > 0;
  if (has_slope) guess.zeta += step * mode.shape_by_mu;
  if (!before) return guess;
  const double h = last.mu - before->mu, s = step / h;
  const Complex bend = before->mode.lambda - mode.lambda + h * mode.by_mu;
  const Complex twist = h * (mode.by_mu - before->mode.by_mu);
  guess.lambda += s * s * (3.0 * bend - twist + s * (2.0 * bend - twist));
  if (has_slope) guess.zeta += s * s * (before->mode.zeta - mode.zeta + h * mode.shape_by_mu);
  return guess;
}

std::optional<FlagMode> followed(const Aerodynamics& F, const FlagOperator& flag,
                                 const std::optional<FollowedMode>& before,
                                 const FollowedMode& last, double mu, int halvings) {
  constexpr double longest_jump = 0.1;  // of lambda from its guess; beyond, it is another mode
  const Guess guess = expected(before, last, mu);
  auto next = flag_mode(F, flag, mu, guess.lambda, guess.zeta);
  if (next && std::abs(next->lambda - guess.lambda) < longest_jump) return next;
  if (halvings == 0) return std::nullopt;
  const double middle = std::sqrt(last.mu * mu);
  auto half = followed(F, flag, std::nullopt, last, middle, halvings - 1);
  if (!half) return std::nullopt;
  return followed(F, flag, std::nullopt, {middle, std::move(*half)}, mu, halvings - 1);
}

}  // namespace

std::optional<FlagMode> flag_mode(const Aerodynamics& F, const FlagOperator& flag, double mu,
                                  Complex lambda_0, const Eigen::VectorXcd& zeta_0) {
  constexpr int most_iterations = 12;
  constexpr double last_step = 3e-5;  // of lambda and zeta; the error that is left is its square
  const Eigen::VectorXcd border = zeta_0.normalized();
  Complex lambda = lambda_0;
  Eigen::VectorXcd zeta = border;
  const Index n = zeta.size();
  for (int iteration = 0; iteration < most_iterations; ++iteration) {
    const Bordered bordered(F, flag, mu, lambda, zeta, border);
    const Eigen::VectorXcd step = bordered.step();
    zeta += step.head(n);
    lambda += step[n];
    if (!std::isfinite(std::abs(lambda))) return std::nullopt;
    if (std::abs(step[n]) > last_step || step.head(n).norm() > last_step) continue;
    const Eigen::VectorXcd by_mu = bordered.by_mu();
    return FlagMode{lambda, zeta.normalized(), by_mu[n], by_mu.head(n) / zeta.norm()};
  }
  return std::nullopt;
}

std::optional<FlagMode> followed(const Aerodynamics& F, const FlagOperator& flag,
                                 const std::optional<FollowedMode>& before,
                                 const FollowedMode& last, double mu) {
  constexpr int most_halvings = 6;
  return followed(F, flag, before, last, mu, most_halvings);
}

Complex correction(const Aerodynamics& F, const FlagOperator& flag, double mu,
                   const FlagMode& mode) {
  return Bordered(F, flag, mu, mode.lambda, mode.zeta, mode.zeta).step()[mode.zeta.size()];
}

Eigen::VectorXcd left_shape(const Aerodynamics& F, const FlagOperator& flag, double mu,
                            const FlagMode& mode) {
  return Bordered(F, flag, mu, mode.lambda, mode.zeta, mode.zeta).from_left();
}

}  // namespace pennon::modes::global

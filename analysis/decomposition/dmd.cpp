#include "analysis/decomposition/dmd.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/decomposition/variable_projection.hpp"
#include "common/errors.hpp"
#include "common/linear_algebra/signal_rank.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

template <class Scalar>
constexpr bool is_real = std::is_same_v<Scalar, double>;

// Singular values below this share of the largest are roundoff.
constexpr double roundoff = 1e-12;
// An eigenvalue theta below this has no logarithm worth its name.
constexpr double vanishing = 1e-8;

Index checked_rank(const VectorXd& sigma, std::size_t values, Index columns,
                   std::optional<Index> asked) {
  if (!(sigma(0) > 0))
    throw InputError("decompose.mean", "all snapshots are zero: there is nothing to decompose");
  const auto n = static_cast<double>(values), m = static_cast<double>(columns);
  if (!asked)
    return std::max<Index>(signal_rank(sigma, std::min(n, m) / std::max(n, m), roundoff), 1);
  const Index most = (sigma.array() > roundoff * sigma(0)).cast<Index>().sum();
  if (*asked > most)
    throw InputError(
        "decompose.rank",
        fmt::format("decompose.rank = {} is above {}, the rank of these data: {} snapshots "
                    "of {} values, whose further singular values are roundoff",
                    *asked, most, columns, values));
  return *asked;
}

// lambda, modes and residuals as they come; b_j and the order follow.
struct Found {
  VectorXcd theta;
  MatrixXcd combination;  // of the M snapshots
  MatrixXcd X_c, Y_c;
  VectorXd growth_variance, omega_variance;  // of lambda
};

template <class Scalar>
struct ExactParts {
  Svd<Scalar> svd;
  Index rank;
  MatrixXcd W;  // eigenvectors of the reduced matrix
  VectorXcd theta;
  DenseMatrix<Scalar> reduced;
};

template <class Scalar>
ExactParts<Scalar> exact_parts(const DenseMatrix<Scalar>& R, std::size_t values,
                               std::optional<Index> asked) {
  const Index pairs = R.cols() - 1;
  ExactParts<Scalar> parts;
  parts.svd = thin_svd<Scalar>(R.leftCols(pairs));
  const auto& [U, sigma, V] = parts.svd;
  parts.rank = checked_rank(sigma, values, pairs, asked);
  parts.reduced = U.leftCols(parts.rank).adjoint() * R.rightCols(pairs) * V.leftCols(parts.rank) *
                  sigma.head(parts.rank).cwiseInverse().asDiagonal();
  const Eigen::ComplexEigenSolver<MatrixXcd> solver(parts.reduced.template cast<Complex>());
  parts.theta = solver.eigenvalues();
  parts.W = solver.eigenvectors();
  return parts;
}

// To first order an error e_m of each snapshot changes theta_j by sum_m l_j^* U^* e_m (c_(m-1) -
// theta c_m): as the later one of a pair, and as the earlier. In white noise of variance s^2 the
// pairs are missed by s^2 (n + |A|^2) each, A the reduced matrix.
template <class Scalar>
void set_exact_errors(const DenseMatrix<Scalar>& R, const ExactParts<Scalar>& parts,
                      const MatrixXcd& c, double dt, std::size_t values, Found& found) {
  const auto& [U, sigma, V] = parts.svd;
  const Index pairs = R.cols() - 1, r = parts.rank;
  const DenseMatrix<Scalar> x = sigma.head(r).asDiagonal() * V.leftCols(r).adjoint();
  const double missed = (R.rightCols(pairs) - U.leftCols(r) * (parts.reduced * x)).squaredNorm();
  const double freedom = static_cast<double>(std::max<Index>(pairs - r, 1)) *
                         (static_cast<double>(values) + parts.reduced.squaredNorm());
  const double noise = missed / freedom;
  const MatrixXcd left = parts.W.fullPivLu().inverse();  // its rows l_j^*, l_j^* w_j = 1
  found.growth_variance.resize(r);
  found.omega_variance.resize(r);
  for (Index j = 0; j < r; ++j) {
    VectorXcd change = VectorXcd::Zero(R.cols());
    change.tail(pairs) += c.col(j);
    change.head(pairs) -= parts.theta(j) * c.col(j);
    change /= parts.theta(j) * dt;
    const double modulus = left.row(j).squaredNorm() * change.squaredNorm();
    const Complex square = is_real<Scalar> ? (left.row(j) * left.row(j).transpose()).value() *
                                                 (change.transpose() * change).value()
                                           : Complex(0);
    found.growth_variance(j) = noise * (modulus + square.real()) / 2;
    found.omega_variance(j) = noise * (modulus - square.real()) / 2;
  }
}

template <class Scalar>
Found exact(const DenseMatrix<Scalar>& R, double dt, std::size_t values,
            const ExactParts<Scalar>& parts) {
  const auto& [U, sigma, V] = parts.svd;
  const Index pairs = R.cols() - 1, r = parts.rank;
  const MatrixXcd c = V.leftCols(r) * sigma.head(r).cwiseInverse().asDiagonal() * parts.W;
  Found found{parts.theta,
              MatrixXcd::Zero(R.cols(), r),
              U.leftCols(r) * parts.W,
              R.rightCols(pairs) * c,
              {},
              {}};
  found.combination.bottomRows(pairs) = c;
  set_exact_errors(R, parts, c, dt, values, found);
  return found;
}

// The rows of Phi^+, as columns: applied to snapshots they give the modes.
MatrixXcd duals(const MatrixXcd& Phi) {
  const Index r = Phi.cols();
  const VectorXd size = Phi.colwise().norm();
  const MatrixXcd scaled = Phi * size.cwiseInverse().cast<Complex>().asDiagonal();
  const Eigen::HouseholderQR<MatrixXcd> factors(scaled);
  const MatrixXcd Q = factors.householderQ() * MatrixXcd::Identity(Phi.rows(), r);
  const MatrixXcd inverse =
      factors.matrixQR().topRows(r).triangularView<Eigen::Upper>().solve(MatrixXcd(Q.adjoint()));
  return (size.cwiseInverse().cast<Complex>().asDiagonal() * inverse).transpose();
}

template <class Scalar>
Found optimised(const DenseMatrix<Scalar>& R, double dt, std::size_t values,
                const ExactParts<Scalar>& start, Index rank, const Svd<Scalar>& whole,
                Dmd& result) {
  const Index M = R.cols(), pairs = M - 1;
  std::vector<double> t;
  for (Index m = 0; m < M; ++m) t.push_back(dt * static_cast<double>(m));
  const MatrixXcd Z = (whole.sigma.head(rank).asDiagonal() * whole.V.leftCols(rank).adjoint())
                          .transpose()
                          .template cast<Complex>();
  VectorXcd lambda(rank);
  for (Index j = 0; j < rank; ++j) {
    const Complex theta = start.theta(j);
    constexpr double fastest_decay = -3;  // of log theta, to start from
    lambda(j) =
        Complex(std::max(std::log(std::abs(theta) + 1e-300), fastest_decay), std::arg(theta)) / dt;
  }
  const ExponentialFit fit = fit_exponentials(Z, t, lambda, is_real<Scalar>);
  const double left =
      fit.misfit_squared + whole.sigma.tail(whole.sigma.size() - rank).squaredNorm();
  result.misfit = std::sqrt(left) / whole.sigma.norm();
  const double n = static_cast<double>(values), r = static_cast<double>(rank);
  const double freedom = std::max(n * static_cast<double>(M) - n * r - r, 1.0);
  const double noise = left / freedom;

  Found found;
  found.theta = (fit.lambda * dt).array().exp();
  found.combination = duals(fit.Phi);
  const MatrixXcd c = duals(fit.Phi.topRows(pairs));
  found.X_c = R.leftCols(pairs) * c;
  found.Y_c = R.rightCols(pairs) * c;
  const VectorXd modulus = fit.variance, square = fit.pseudo_variance.real();
  found.growth_variance = noise * (modulus + square) / 2;
  found.omega_variance = noise * (modulus - square) / 2;
  return found;
}

}  // namespace

template <class Scalar>
Dmd dmd(const DenseMatrix<Scalar>& R, double dt, std::size_t values, DmdVariant variant,
        std::optional<Index> asked) {
  if (R.cols() < 3)
    throw InputError(
        "decompose.method",
        fmt::format("dynamic modes need 3 snapshots at least; there are {}", R.cols()));
  Dmd result;
  ExactParts<Scalar> parts;
  Found found;
  if (variant == DmdVariant::exact) {
    parts = exact_parts(R, values, asked);
    result.rank = parts.rank;
    found = exact(R, dt, values, parts);
  } else {
    const Svd<Scalar> whole = thin_svd(R);
    result.rank = checked_rank(whole.sigma, values, R.cols(), asked);
    result.rank = std::min(result.rank, R.cols() - 1);
    parts = exact_parts(R, values, result.rank);
    found = optimised(R, dt, values, parts, result.rank, whole, result);
  }

  const Index M = R.cols();
  std::vector<Index> kept;
  for (Index j = 0; j < result.rank; ++j)
    if (std::abs(found.theta(j)) > vanishing) kept.push_back(j);
  result.vanished = result.rank - static_cast<Index>(kept.size());
  const auto count = static_cast<Index>(kept.size());
  MatrixXcd phi(R.rows(), count);
  result.combination.resize(M, count);
  for (Index k = 0; k < count; ++k) {
    const Index j = kept[static_cast<std::size_t>(k)];
    phi.col(k) = R * found.combination.col(j);
    const double size = phi.col(k).norm();
    phi.col(k) /= size;
    result.combination.col(k) = found.combination.col(j) / size;
  }
  const VectorXcd b = phi.colPivHouseholderQr().solve(R.col(0).template cast<Complex>());
  std::vector<DmdMode> modes;
  std::vector<double> mean_square;
  for (Index k = 0; k < count; ++k) {
    const Index j = kept[static_cast<std::size_t>(k)];
    const Complex theta = found.theta(j);
    // The phase of a mode is that with which the first snapshot holds it.
    result.combination.col(k) *= b(k) == 0.0 ? Complex(1) : b(k) / std::abs(b(k));
    modes.push_back({std::log(theta) / dt, std::abs(b(k)),
                     (found.Y_c.col(j) - theta * found.X_c.col(j)).norm() /
                         (std::abs(theta) * found.X_c.col(j).norm()),
                     std::sqrt(found.growth_variance(j)),
                     std::sqrt(std::max(found.omega_variance(j), 0.0))});
    double sum = 0;
    for (Index m = 0; m < M; ++m)
      sum += std::exp(2 * modes.back().lambda.real() * dt * static_cast<double>(m));
    mean_square.push_back(std::norm(b(k)) * sum);
  }
  std::vector<Index> order(modes.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, [&](Index a, Index other) {
    return mean_square[static_cast<std::size_t>(a)] > mean_square[static_cast<std::size_t>(other)];
  });
  const MatrixXcd unsorted = result.combination;
  for (Index k = 0; k < count; ++k) {
    result.combination.col(k) = unsorted.col(order[static_cast<std::size_t>(k)]);
    result.modes.push_back(modes[static_cast<std::size_t>(order[static_cast<std::size_t>(k)])]);
  }
  return result;
}

template Dmd dmd(const DenseMatrix<double>&, double, std::size_t, DmdVariant, std::optional<Index>);
template Dmd dmd(const DenseMatrix<Complex>&, double, std::size_t, DmdVariant,
                 std::optional<Index>);

}  // namespace pennon::decomposition

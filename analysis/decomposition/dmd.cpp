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
#include "common/linear_algebra/stacked_qr.hpp"

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
    throw InputError("[decompose]", "all snapshots are zero: there is nothing to decompose");
  const auto n = static_cast<double>(values), m = static_cast<double>(columns);
  if (!asked)
    return std::max<Index>(signal_rank(sigma, std::min(n, m) / std::max(n, m), roundoff), 1);
  const Index most = (sigma.array() > roundoff * sigma(0)).cast<Index>().sum();
  if (*asked > most)
    throw InputError(
        "[decompose]",
        fmt::format("decompose.rank = {} is above {}, the rank of these data: {} "
                    "snapshots of {} values, whose further singular values are roundoff; "
                    "decompose.delays makes it higher",
                    *asked, most, columns, values));
  return *asked;
}

// What both variants find, mode by mode as they come.
struct Found {
  VectorXcd theta;
  MatrixXcd combination;  // of the M snapshots: each mode's part in the first snapshot
  VectorXd residual;
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
ExactParts<Scalar> exact_parts(const DenseMatrix<Scalar>& H, std::size_t values,
                               std::optional<Index> asked) {
  const Index pairs = H.cols() - 1;
  ExactParts<Scalar> parts;
  parts.svd = thin_svd<Scalar>(H.leftCols(pairs));
  const auto& [U, sigma, V] = parts.svd;
  parts.rank = checked_rank(sigma, values, pairs, asked);
  parts.reduced = U.leftCols(parts.rank).adjoint() * H.rightCols(pairs) * V.leftCols(parts.rank) *
                  sigma.head(parts.rank).cwiseInverse().asDiagonal();
  const Eigen::ComplexEigenSolver<MatrixXcd> solver(parts.reduced.template cast<Complex>());
  parts.theta = solver.eigenvalues();
  parts.W = solver.eigenvectors();
  return parts;
}

// Each snapshot with the d - 1 behind it, one below the other, by their triangular factor.
template <class Scalar>
DenseMatrix<Scalar> stacked(const DenseMatrix<Scalar>& R, Index delays) {
  if (delays == 1) return R;
  const Index columns = R.cols() - delays + 1;
  StackedQr<Scalar> factor(columns);
  for (Index d = 0; d < delays; ++d) factor.add(R.middleCols(d, columns));
  return factor.R();
}

// To first order an error e_m of each snapshot changes theta_j by sum_m l_j^* U^* e_m (c_(m-1) -
// theta c_m): as the later one of a pair, and as the earlier. In white noise of variance s^2 the
// pairs are missed by s^2 (n + |A|^2) each, A the reduced matrix.
template <class Scalar>
void set_exact_errors(const DenseMatrix<Scalar>& H, const ExactParts<Scalar>& parts,
                      const MatrixXcd& c, double dt, std::size_t values, Found& found) {
  const auto& [U, sigma, V] = parts.svd;
  const Index pairs = H.cols() - 1, r = parts.rank;
  const DenseMatrix<Scalar> x = sigma.head(r).asDiagonal() * V.leftCols(r).adjoint();
  const double missed = (H.rightCols(pairs) - U.leftCols(r) * (parts.reduced * x)).squaredNorm();
  const double freedom = static_cast<double>(std::max<Index>(pairs - r, 1)) *
                         (static_cast<double>(values) + parts.reduced.squaredNorm());
  const double noise = missed / freedom;
  const MatrixXcd left = parts.W.fullPivLu().inverse();  // its rows l_j^*, l_j^* w_j = 1
  found.growth_variance.resize(r);
  found.omega_variance.resize(r);
  for (Index j = 0; j < r; ++j) {
    VectorXcd change = VectorXcd::Zero(H.cols());
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
Found exact(const DenseMatrix<Scalar>& R, const DenseMatrix<Scalar>& H, double dt,
            std::size_t values, const ExactParts<Scalar>& parts) {
  const auto& [U, sigma, V] = parts.svd;
  const Index pairs = H.cols() - 1, r = parts.rank;
  const MatrixXcd c = V.leftCols(r) * sigma.head(r).cwiseInverse().asDiagonal() * parts.W;
  const MatrixXcd X_c = U.leftCols(r) * parts.W, Y_c = H.rightCols(pairs) * c;
  Found found{parts.theta, MatrixXcd::Zero(R.cols(), r), VectorXd(r), {}, {}};
  const VectorXcd b = Y_c.colPivHouseholderQr().solve(H.col(0).template cast<Complex>());
  for (Index j = 0; j < r; ++j) {
    found.combination.col(j).segment(1, pairs) = b(j) * c.col(j);
    found.residual(j) = (Y_c.col(j) - parts.theta(j) * X_c.col(j)).norm() /
                        (std::abs(parts.theta(j)) * X_c.col(j).norm());
  }
  set_exact_errors(H, parts, c, dt, values, found);
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
Found optimised(const DenseMatrix<Scalar>& R, const DenseMatrix<Scalar>& H, double dt,
                std::size_t values, Index rank) {
  const Index M = R.cols(), pairs = M - 1;
  const Svd<Scalar> whole = thin_svd(R);
  const Index signals = std::min<Index>(
      rank, (whole.sigma.array() > roundoff * whole.sigma(0)).template cast<Index>().sum());
  std::vector<double> t;
  t.reserve(static_cast<std::size_t>(M));
  for (Index m = 0; m < M; ++m) t.push_back(dt * static_cast<double>(m));
  const MatrixXcd Z = (whole.sigma.head(signals).asDiagonal() * whole.V.leftCols(signals).adjoint())
                          .transpose()
                          .template cast<Complex>();
  const ExactParts<Scalar> start = exact_parts(H, values, rank);
  VectorXcd lambda(rank);
  for (Index j = 0; j < rank; ++j) {
    constexpr double fastest_decay = -3;  // of log theta, to start from
    const Complex theta = start.theta(j);
    lambda(j) =
        Complex(std::max(std::log(std::abs(theta) + 1e-300), fastest_decay), std::arg(theta)) / dt;
  }
  const ExponentialFit fit = fit_exponentials(Z, t, lambda, is_real<Scalar>);
  const double left =
      fit.misfit_squared + whole.sigma.tail(whole.sigma.size() - signals).squaredNorm();
  const double n = static_cast<double>(values), r = static_cast<double>(rank);
  const double noise = left / std::max(n * static_cast<double>(M) - n * r - r, 1.0);

  Found found;
  found.theta = (fit.lambda * dt).array().exp();
  found.combination = duals(fit.Phi);
  const MatrixXcd c = duals(fit.Phi.topRows(pairs));
  const MatrixXcd X_c = R.leftCols(pairs) * c, Y_c = R.rightCols(pairs) * c;
  found.residual.resize(rank);
  for (Index j = 0; j < rank; ++j)
    found.residual(j) = (Y_c.col(j) - found.theta(j) * X_c.col(j)).norm() /
                        (std::abs(found.theta(j)) * X_c.col(j).norm());
  const VectorXd square = fit.pseudo_variance.real();
  found.growth_variance = noise * (fit.variance + square) / 2;
  found.omega_variance = noise * (fit.variance - square) / 2;
  return found;
}

// What the sum of all modes leaves of the snapshots, over their norm.
template <class Scalar>
double misfit_of(const DenseMatrix<Scalar>& R, const VectorXcd& theta, const MatrixXcd& parts) {
  double left = 0;
  VectorXcd power = VectorXcd::Ones(theta.size());
  for (Index m = 0; m < R.cols(); ++m) {
    left += (R.col(m).template cast<Complex>() - parts * power).squaredNorm();
    power = power.cwiseProduct(theta);
  }
  return std::sqrt(left) / R.norm();
}

// The largest mean square first; of the two of a pair that with omega > 0.
std::vector<Index> order_of(const VectorXcd& theta, const VectorXd& mean_square, bool is_real) {
  std::vector<Index> order(static_cast<std::size_t>(theta.size()));
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, std::ranges::greater(), [&](Index j) { return mean_square(j); });
  constexpr double same = 1e-6;
  if (is_real)
    for (std::size_t k = 0; k + 1 < order.size(); ++k) {
      const Complex first = theta(order[k]), second = theta(order[k + 1]);
      if (first.imag() < 0 && std::abs(second - std::conj(first)) < same * std::abs(first))
        std::swap(order[k], order[k + 1]);
    }
  return order;
}

// How many snapshots are stacked: where the optimised variant is asked for more exponentials than
// there are shapes, so many that their start can be told.
template <class Scalar>
Index delays_for(const DenseMatrix<Scalar>& R, std::size_t values, const DmdChoice& choice) {
  if (choice.variant == DmdVariant::exact || !choice.rank) return choice.delays;
  const Index M = R.cols();
  if (*choice.rank <= checked_rank(singular_values(R), values, M, {})) return choice.delays;
  const Index enough = *choice.rank / std::min(R.rows(), M) + 2;
  return std::max(choice.delays, std::min(enough, M / 2));
}

// The optimised fit; without a rank that was asked for, of one that can be fitted.
template <class Scalar>
Found fitted(const DenseMatrix<Scalar>& R, const DenseMatrix<Scalar>& H, double dt,
             std::size_t values, Index delays, std::optional<Index> asked, Dmd& result) {
  const Index pairs = H.cols() - 1;
  result.rank = checked_rank(singular_values<Scalar>(H.leftCols(pairs)),
                             values * static_cast<std::size_t>(delays), pairs, asked);
  result.rank_of_signal = result.rank;
  while (true) {
    try {
      return optimised(R, H, dt, values, result.rank);
    } catch (const SolverError&) {
      if (asked || result.rank == 1) throw;
      result.rank = std::min(result.rank - 1, result.rank * 4 / 5);
    }
  }
}

// The modes with their norms, phases, order and misfit, of what was found.
template <class Scalar>
void set_modes(const DenseMatrix<Scalar>& R, double dt, const Found& found, Dmd& result) {
  const Index M = R.cols();
  std::vector<Index> kept;
  for (Index j = 0; j < result.rank; ++j)
    if (std::abs(found.theta(j)) > vanishing) kept.push_back(j);
  result.vanished = result.rank - static_cast<Index>(kept.size());
  const MatrixXcd parts = R * found.combination(Eigen::all, kept);
  const VectorXcd theta = found.theta(kept);
  result.misfit = misfit_of(R, theta, parts);
  VectorXd mean_square(theta.size());
  for (Index k = 0; k < theta.size(); ++k) {
    double sum = 0;
    for (Index m = 0; m < M; ++m) sum += std::pow(std::norm(theta(k)), static_cast<double>(m));
    mean_square(k) = parts.col(k).squaredNorm() * sum;
  }
  result.combination.resize(M, theta.size());
  for (const Index k : order_of(theta, mean_square, is_real<Scalar>)) {
    const Index j = kept[static_cast<std::size_t>(k)];
    const DmdMode mode{std::log(theta(k)) / dt, parts.col(k).norm(), found.residual(j),
                       std::sqrt(std::max(found.growth_variance(j), 0.0)),
                       std::sqrt(std::max(found.omega_variance(j), 0.0))};
    if (!std::isfinite(mode.amplitude + mode.growth_error + mode.omega_error))
      throw SolverError(
          fmt::format("the dynamic modes of rank {} are no numbers: two of them are the same to "
                      "rounding; decompose.rank takes fewer",
                      result.rank));
    result.combination.col(static_cast<Index>(result.modes.size())) =
        found.combination.col(j) / std::max(mode.amplitude, 1e-300);
    result.modes.push_back(mode);
  }
}

}  // namespace

template <class Scalar>
Dmd dmd(const DenseMatrix<Scalar>& R, double dt, std::size_t values, const DmdChoice& choice) {
  if (R.cols() < choice.delays + 2)
    throw InputError(
        "[decompose]",
        fmt::format(
            "dynamic modes with decompose.delays = {} need {} snapshots at least; there are {}",
            choice.delays, choice.delays + 2, R.cols()));
  Dmd result;
  const Index delays = delays_for(R, values, choice);
  const DenseMatrix<Scalar> H = stacked(R, delays);
  if (choice.variant == DmdVariant::optimised) {
    set_modes(R, dt, fitted(R, H, dt, values, delays, choice.rank, result), result);
    return result;
  }
  const std::size_t stacked_values = values * static_cast<std::size_t>(delays);
  const ExactParts<Scalar> parts = exact_parts(H, stacked_values, choice.rank);
  result.rank = parts.rank;
  set_modes(R, dt, exact(R, H, dt, stacked_values, parts), result);
  return result;
}

template Dmd dmd(const DenseMatrix<double>&, double, std::size_t, const DmdChoice&);
template Dmd dmd(const DenseMatrix<Complex>&, double, std::size_t, const DmdChoice&);

}  // namespace pennon::decomposition

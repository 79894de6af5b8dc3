#include "analysis/signal/exponentials.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/linear_algebra/signal_rank.hpp"
#include "common/linear_algebra/svd.hpp"

namespace pennon::analysis {
namespace {

using Matrix = Eigen::MatrixXcd;
using Vector = Eigen::VectorXcd;

// Singular values below this share of the largest are roundoff.
constexpr double roundoff = 1e-9;

Matrix hankel(const Complexes& samples) {
  const auto columns = static_cast<Eigen::Index>(samples.size() / 3 + 1);
  const Eigen::Index rows = static_cast<Eigen::Index>(samples.size()) - columns + 1;
  Matrix matrix(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) matrix(i, j) = samples[static_cast<std::size_t>(i + j)];
  return matrix;
}

// The amplitudes that fit the samples best, in the least-squares sense.
Vector amplitudes_of(const Vector& z, const Complexes& samples) {
  const auto count = static_cast<Eigen::Index>(samples.size());
  Matrix powers(count, z.size());
  powers.row(0).setOnes();
  for (Eigen::Index k = 1; k < count; ++k)
    powers.row(k) = powers.row(k - 1).cwiseProduct(z.transpose());
  const Eigen::RowVectorXd sizes = powers.colwise().norm();
  powers.array().rowwise() /= sizes.array().cast<std::complex<double>>();
  const Vector scaled =
      powers.colPivHouseholderQr().solve(Eigen::Map<const Vector>(samples.data(), count));
  return scaled.cwiseQuotient(sizes.transpose().cast<std::complex<double>>());
}

}  // namespace

std::vector<Exponential> fit_exponentials(const Complexes& samples, double dt, std::size_t most) {
  assert(samples.size() >= 8);
  const Matrix matrix = hankel(samples);
  const auto [U, sigma, V] = thin_svd(matrix);
  if (!(sigma(0) > 0)) return {};
  const double beta = static_cast<double>(matrix.cols()) / static_cast<double>(matrix.rows());
  const Eigen::Index rank =
      std::min(signal_rank(sigma, beta, roundoff), static_cast<Eigen::Index>(most));
  if (rank == 0) return {};
  const Matrix space = V.leftCols(rank).conjugate();
  const Eigen::Index shifted = space.rows() - 1;
  const Matrix shift =
      space.topRows(shifted).colPivHouseholderQr().solve(space.bottomRows(shifted));
  const Vector z = Eigen::ComplexEigenSolver<Matrix>(shift, false).eigenvalues();
  const Vector amplitudes = amplitudes_of(z, samples);
  std::vector<Exponential> found;
  for (Eigen::Index i = 0; i < rank; ++i) found.push_back({std::log(z(i)) / dt, amplitudes(i)});
  return found;
}

}  // namespace pennon::analysis

#include "analysis/decomposition/pod.hpp"

#include <algorithm>
#include <cmath>

#include "common/errors.hpp"

namespace pennon::decomposition {

template <class Scalar>
Pod<Scalar> pod(const DenseMatrix<Scalar>& R, bool mean_is_removed, Eigen::Index modes) {
  const auto M = static_cast<double>(R.cols());
  const auto [U, sigma, V] = thin_svd(R);
  const bool ends_in_zero = mean_is_removed && R.rows() >= R.cols();
  Pod<Scalar> found;
  found.energy = sigma.head(sigma.size() - (ends_in_zero ? 1 : 0)).cwiseAbs2() / M;
  found.variance = found.energy.sum();
  if (!(found.variance > 0))
    throw InputError(
        "[decompose]",
        mean_is_removed
            ? "all snapshots are equal, or differ by numbers whose squares vanish: with "
              "decompose.mean = \"removed\" nothing is left to decompose"
            : "all snapshots are zero: there is nothing to decompose");
  const Eigen::Index count =
      std::min(modes, (found.energy.array() > 0).template cast<Eigen::Index>().sum());
  found.coefficients = sigma.head(count).asDiagonal() * V.leftCols(count).adjoint();
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> turn(count);
  // Signs and phases: the largest coefficient of each mode is positive.
  for (Eigen::Index j = 0; j < count; ++j) {
    Eigen::Index largest = 0;
    found.coefficients.row(j).cwiseAbs().maxCoeff(&largest);
    const Scalar value = found.coefficients(j, largest);
    turn(j) = value / std::abs(value);
    found.coefficients.row(j) /= turn(j);
  }
  found.combination =
      V.leftCols(count) * turn.asDiagonal() * sigma.head(count).cwiseInverse().asDiagonal();
  return found;
}

template Pod<double> pod(const DenseMatrix<double>&, bool, Eigen::Index);
template Pod<std::complex<double>> pod(const DenseMatrix<std::complex<double>>&, bool,
                                       Eigen::Index);

}  // namespace pennon::decomposition

#include "analysis/decomposition/bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/signal/series.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Each row at other times, by the natural cubic spline through it.
MatrixXd at_times(const MatrixXd& rows, const std::vector<double>& t,
                  const std::vector<double>& times) {
  MatrixXd found(rows.rows(), static_cast<Index>(times.size()));
  std::vector<double> values(t.size());
  for (Index i = 0; i < rows.rows(); ++i) {
    Eigen::Map<Eigen::RowVectorXd>(values.data(), rows.cols()) = rows.row(i);
    const std::vector<double> moved = analysis::at_times(t, values, times);
    found.row(i) = Eigen::Map<const Eigen::RowVectorXd>(moved.data(), found.cols());
  }
  return found;
}

Eigen::MatrixXcd at_times(const Eigen::MatrixXcd& rows, const std::vector<double>& t,
                          const std::vector<double>& times) {
  Eigen::MatrixXcd found(rows.rows(), static_cast<Index>(times.size()));
  found.real() = at_times(MatrixXd(rows.real()), t, times);
  found.imag() = at_times(MatrixXd(rows.imag()), t, times);
  return found;
}

}  // namespace

template <class Scalar>
DenseMatrix<Scalar> BandOfData<Scalar>::weighted() const {
  if (weight.cols() == 1) return weight.col(0).cwiseSqrt().asDiagonal() * q;
  return q.cwiseProduct(weight.cwiseSqrt().template cast<Scalar>());
}

template <class Scalar>
Bands<Scalar>::Bands(const Snapshots& snapshots, Preparation preparation)
    : snapshots_(snapshots),
      preparation_(preparation),
      times_(time_grid(snapshots.layout().t, snapshots.layout().name)) {}

template <class Scalar>
Band Bands<Scalar>::mine() const {
  const auto ranks = static_cast<std::size_t>(ranks::count());
  const auto rank = static_cast<std::size_t>(ranks::mine());
  const std::size_t values = layout().values();
  const std::size_t begin = values * rank / ranks, end = values * (rank + 1) / ranks;
  return {begin, end - begin};
}

template <class Scalar>
BandOfData<Scalar> Bands<Scalar>::prepared(Band band) const {
  if (band.count == 0)
    return {band, DenseMatrix<Scalar>(0, snapshots()),
            MatrixXd(0, layout().has_changing_weights ? snapshots() : 1)};
  BandOfData<Scalar> data{band, values_of<Scalar>(snapshots_, band), snapshots_.weights(band)};
  if (times_.is_resampled) {
    data.q = at_times(data.q, layout().t, times_.t);
    // Weights are positive, and a spline need not be.
    if (layout().has_changing_weights)
      data.weight = at_times(data.weight, layout().t, times_.t).cwiseMax(0);
  }
  if (preparation_.removes_mean) data.q.colwise() -= data.q.rowwise().mean().eval();
  return data;
}

template <class Scalar>
void Bands<Scalar>::for_each(double bytes_per_value, double bytes, const Use& use) const {
  const Band all = mine();
  const auto M = static_cast<double>(snapshots());
  // The values, twice where they are resampled or weighted, and weights that change.
  const double of_value =
      (2 * sizeof(Scalar) + (layout().has_changing_weights ? 2 * sizeof(double) : 0)) * M +
      bytes_per_value;
  const double mine = preparation_.memory / ranks::count();
  const double most = std::floor((mine - bytes) / of_value);
  if (!(most >= 1)) {
    const double needed = ranks::count() * (bytes + of_value);
    throw InputError(
        "decompose.memory",
        fmt::format("decompose.memory = {:.3g} GB is too little for {} snapshots: {:.3g} GB "
                    "at least are needed; take fewer snapshots with decompose.from and "
                    "decompose.to, or shorter blocks",
                    preparation_.memory / 1e9, snapshots(), needed / 1e9));
  }
  const auto width = static_cast<std::size_t>(std::min(most, 1e15));
  // As many bands on every rank, the last ones perhaps empty, so that ranks can meet in each.
  const std::size_t longest = layout().values() / static_cast<std::size_t>(ranks::count()) + 1;
  const std::size_t end = all.first + all.count, bands = (longest + width - 1) / width;
  for (std::size_t k = 0; k < bands; ++k) {
    const std::size_t first = std::min(all.first + k * width, end);
    use(prepared({first, std::min(width, end - first)}));
  }
}

template struct BandOfData<double>;
template struct BandOfData<std::complex<double>>;
template class Bands<double>;
template class Bands<std::complex<double>>;

}  // namespace pennon::decomposition

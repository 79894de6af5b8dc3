#include "analysis/decomposition/bands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/signal/series.hpp"
#include "common/errors.hpp"
#include "common/interrupt.hpp"
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

// Numbers whose squares are none.
template <class Vector>
void expect_squares(const Vector& sum) {
  constexpr double largest = 1e140;
  if (sum.cwiseAbs().maxCoeff() > largest)
    throw InputError(
        "[decompose]",
        fmt::format("the data have values as large as {:.2g}, whose squares are no numbers; "
                    "scale the data below {:.0e}",
                    sum.cwiseAbs().maxCoeff(), largest));
}

// What is left of a value that does not change is rounding, and counts as nothing.
template <class Scalar>
void remove_mean(BandOfData<Scalar>& data) {
  constexpr double rounding = 1e-15;
  const Eigen::ArrayXd slack = rounding * data.mean.cwiseAbs().array();
  for (Index m = 0; m < data.A.cols(); ++m) {
    auto values = data.A.col(m).array();
    values -= data.mean.array();
    values = (values.abs() > slack).select(values, Scalar(0));
  }
}

}  // namespace

template <class Scalar>
void BandOfData<Scalar>::take_weight_from(MatrixXd& modes) const {
  for (Index i = 0; i < modes.rows(); ++i)
    modes.row(i) *= mean_weight(i) > 0 ? 1 / std::sqrt(mean_weight(i)) : 0;
}

template <class Scalar>
void BandOfData<Scalar>::take_weight_from(Eigen::MatrixXcd& modes) const {
  for (Index i = 0; i < modes.rows(); ++i)
    modes.row(i) *= mean_weight(i) > 0 ? 1 / std::sqrt(mean_weight(i)) : 0;
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
void Bands<Scalar>::apply_weights(BandOfData<Scalar>& data) const {
  data.mean_weight = Eigen::VectorXd::Ones(data.A.rows());
  if (!preparation_.is_weighted) return;
  MatrixXd weight = snapshots_.weights(data.band);
  if (weight.cols() == 1) {
    data.mean_weight = weight.col(0);
    const Eigen::VectorXd root = data.mean_weight.cwiseSqrt();
    if ((root.array() == 1).all()) return;
    for (Index m = 0; m < data.A.cols(); ++m) data.A.col(m).array() *= root.array();
    return;
  }
  // Weights are 0 or more, and a spline need not be.
  if (times_.is_resampled) weight = at_times(weight, layout().t, times_.t).cwiseMax(0);
  data.mean_weight = weight.rowwise().mean();
  if (preparation_.has_mean_weight)
    data.A.array().colwise() *= data.mean_weight.array().sqrt().template cast<Scalar>();
  else
    data.A.array() *= weight.array().sqrt();
}

template <class Scalar>
void Bands<Scalar>::read(Band band, BandOfData<Scalar>& data) const {
  data.band = band;
  if (band.count == 0) {
    data.A.resize(0, snapshots());
    data.mean_weight.resize(0);
    data.mean.resize(0);
    return;
  }
  read_values(snapshots_, band, data.A);
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> sum = data.A.col(0);
  for (Index m = 1; m < data.A.cols(); ++m) sum += data.A.col(m);
  if (!sum.allFinite()) expect_finite(layout(), data.A, band.first);
  if (times_.is_resampled) data.A = at_times(data.A, layout().t, times_.t);
  if (times_.is_resampled) sum = data.A.rowwise().sum();
  expect_squares(sum);
  data.mean = sum / static_cast<double>(data.A.cols());
  if (preparation_.removes_mean) remove_mean(data);
  apply_weights(data);
}

template <class Scalar>
void Bands<Scalar>::for_each(double bytes_per_value, double bytes, const Use& use) const {
  const Band all = mine();
  const auto M = static_cast<double>(snapshots());
  // The values, with copies where they are resampled, and weights that change.
  const double copies = times_.is_resampled ? 3 : 1,
               weights = layout().has_changing_weights ? 2 : 0;
  const double of_value =
      (copies * sizeof(Scalar) + weights * sizeof(double)) * M + bytes_per_value;
  const double mine = preparation_.memory / ranks::count();
  const double most = std::floor((mine - bytes) / of_value);
  if (!(most >= 1)) {
    const double needed = ranks::count() * (bytes + of_value);
    throw InputError(
        "[decompose]",
        fmt::format("decompose.memory = {:.3g} GB is too little for {} snapshots: {:.3g} GB "
                    "at least are needed; take fewer snapshots with decompose.from and "
                    "decompose.to, or shorter blocks",
                    preparation_.memory / 1e9, snapshots(), needed / 1e9));
  }
  // Wider bands than this are read no faster, and leave the caches sooner.
  constexpr double wide = 256e6;  // bytes of values
  const auto width = static_cast<std::size_t>(
      std::min(most, std::max(std::ceil(wide / (sizeof(Scalar) * M)), 1.0)));
  // As many bands on every rank, the last ones perhaps empty, so that ranks can meet in each.
  const std::size_t longest = layout().values() / static_cast<std::size_t>(ranks::count()) + 1;
  const std::size_t end = all.first + all.count, bands = (longest + width - 1) / width;
  BandOfData<Scalar> data;
  for (std::size_t k = 0; k < bands; ++k) {
    stop_if_interrupted("nothing was written");
    const std::size_t first = std::min(all.first + k * width, end);
    read({first, std::min(width, end - first)}, data);
    use(data);
  }
}

template struct BandOfData<double>;
template struct BandOfData<std::complex<double>>;
template class Bands<double>;
template class Bands<std::complex<double>>;

}  // namespace pennon::decomposition

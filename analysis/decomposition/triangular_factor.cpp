#include "analysis/decomposition/triangular_factor.hpp"

#include "common/linear_algebra/stacked_qr.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

// The factors of all ranks one above the other, on every rank.
template <class Scalar>
DenseMatrix<Scalar> gathered(const DenseMatrix<Scalar>& mine) {
  constexpr std::size_t reals = sizeof(Scalar) / sizeof(double);
  const DenseMatrix<Scalar> turned = mine.transpose();
  const std::vector<double> all =
      ranks::gather_all({reinterpret_cast<const double*>(turned.data()),
                         static_cast<std::size_t>(turned.size()) * reals});
  const auto rows = static_cast<Eigen::Index>(all.size() / reals) / mine.cols();
  return Eigen::Map<const DenseMatrix<Scalar>>(reinterpret_cast<const Scalar*>(all.data()),
                                               mine.cols(), rows)
      .transpose();
}

}  // namespace

template <class Scalar>
DenseMatrix<Scalar> gathered_factor(const DenseMatrix<Scalar>& mine) {
  if (ranks::count() == 1) return mine;
  StackedQr<Scalar> of_all(mine.cols());
  of_all.add(gathered(mine));
  return of_all.R();
}
template <class Scalar>
DenseMatrix<Scalar> triangular_factor(const Bands<Scalar>& bands) {
  const auto M = static_cast<double>(bands.snapshots());
  StackedQr<Scalar> factor(bands.snapshots());
  constexpr double factors = 3;  // the factor, its copy, and what is added to it
  bands.for_each(sizeof(Scalar) * M, factors * sizeof(Scalar) * M * M,
                 [&](const BandOfData<Scalar>& data) { factor.add(data.A); });
  return gathered_factor(factor.R());
}

template DenseMatrix<double> gathered_factor(const DenseMatrix<double>&);
template DenseMatrix<std::complex<double>> gathered_factor(
    const DenseMatrix<std::complex<double>>&);
template DenseMatrix<double> triangular_factor(const Bands<double>&);
template DenseMatrix<std::complex<double>> triangular_factor(const Bands<std::complex<double>>&);

}  // namespace pennon::decomposition

/// Modes that are sums of snapshots, once their coefficients are known.
#pragma once

#include <functional>

#include "analysis/decomposition/bands.hpp"

namespace pennon::decomposition {

/// For each band of this rank: phi = W^-1/2 A C, values x modes, with the weighted snapshots A and
/// C the combination; with weights that change with time W is their mean. A value whose weight is
/// zero is q C for constant weights and 0 else.
template <class Scalar, class Mode>
void for_each_band_of_modes(const Bands<Scalar>& bands, const DenseMatrix<Mode>& combination,
                            const std::function<void(Band, const DenseMatrix<Mode>&)>& use) {
  const auto modes = static_cast<double>(combination.cols());
  bands.for_each(sizeof(Mode) * 2 * modes, sizeof(Mode) * static_cast<double>(combination.size()),
                 [&](const BandOfData<Scalar>& data) {
                   if (data.weight.cols() == 1) return use(data.band, data.q * combination);
                   DenseMatrix<Mode> phi = data.weighted() * combination;
                   const Eigen::VectorXd mean = data.weight.rowwise().mean();
                   for (Eigen::Index i = 0; i < phi.rows(); ++i)
                     phi.row(i) *= mean(i) > 0 ? 1 / std::sqrt(mean(i)) : 0;
                   use(data.band, phi);
                 });
}

}  // namespace pennon::decomposition

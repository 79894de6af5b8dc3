/// Modes that are sums of snapshots, once their coefficients are known.
#pragma once

#include <functional>

#include "analysis/decomposition/bands.hpp"

namespace pennon::decomposition {

/// For each band of this rank: phi = W^-1/2 A C, values x modes, with the weighted snapshots A and
/// C the combination; W is the mean weight, and phi is 0 where that is 0.
template <class Scalar, class Mode>
void for_each_band_of_modes(
    const Bands<Scalar>& bands, const DenseMatrix<Mode>& combination,
    const std::function<void(const BandOfData<Scalar>&, const DenseMatrix<Mode>&)>& use) {
  const auto modes = static_cast<double>(combination.cols());
  DenseMatrix<Mode> phi;
  bands.for_each(sizeof(Mode) * 2 * modes, sizeof(Mode) * static_cast<double>(combination.size()),
                 [&](const BandOfData<Scalar>& data) {
                   phi.noalias() = data.A * combination;
                   data.take_weight_from(phi);
                   use(data, phi);
                 });
}

}  // namespace pennon::decomposition

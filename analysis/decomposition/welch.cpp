#include "analysis/decomposition/welch.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::decomposition {
namespace {

// Symmetric about the middle of the block: both ends have the same value.
Eigen::VectorXd window_of(Eigen::Index length, Taper taper) {
  const double mean = taper == Taper::hamming ? 0.54 : taper == Taper::hann ? 0.5 : 1;
  Eigen::VectorXd w(length);
  for (Eigen::Index m = 0; m < length; ++m)
    w(m) = mean - (1 - mean) * std::cos(2 * std::numbers::pi * static_cast<double>(m) /
                                        static_cast<double>(length - 1));
  return w * std::sqrt(static_cast<double>(length) / w.squaredNorm());
}

}  // namespace

double Blocks::independent() const {
  const auto B = static_cast<double>(count());
  if (count() < 2) return B;
  const Eigen::Index step = first[1] - first[0];
  double sum = 1;
  for (Eigen::Index k = 1; k < count() && k * step < length; ++k) {
    const double correlation = window.head(length - k * step).dot(window.tail(length - k * step)) /
                               static_cast<double>(length);
    sum += 2 * (1 - static_cast<double>(k) / B) * correlation * correlation;
  }
  return B / sum;
}

Blocks welch_blocks(Eigen::Index snapshots, Eigen::Index length, double overlap, Taper taper) {
  constexpr Eigen::Index shortest = 4;
  if (length < shortest)
    throw InputError("[decompose]", fmt::format("decompose.block = {} is below {}, the fewest "
                                                "snapshots in which a frequency can be told",
                                                length, shortest));
  if (length > snapshots)
    throw InputError(
        "[decompose]",
        fmt::format("decompose.block = {} is more than the {} snapshots there are; shorter "
                    "blocks, or more snapshots, make one at least",
                    length, snapshots));
  const auto shared = static_cast<Eigen::Index>(std::floor(overlap * static_cast<double>(length)));
  const Eigen::Index step = std::max<Eigen::Index>(length - shared, 1);
  Blocks blocks{length, {}, window_of(length, taper)};
  for (Eigen::Index first = 0; first + length <= snapshots; first += step)
    blocks.first.push_back(first);
  return blocks;
}

}  // namespace pennon::decomposition

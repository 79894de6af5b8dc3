/// The blocks into which Welch's method (1967) cuts a series of snapshots: so many snapshots each,
/// the next one begins before the one before has ended, and each is multiplied by a window w,
/// scaled to mean(w^2) = 1.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace pennon::decomposition {

enum class Taper { hamming, hann, none };

struct Blocks {
  Eigen::Index length = 0;          ///< snapshots in a block, N
  std::vector<Eigen::Index> first;  ///< snapshot of each block
  Eigen::VectorXd window;           ///< w, N values

  Eigen::Index count() const { return static_cast<Eigen::Index>(first.size()); }
  /// Frequencies k/(N dt): for real data from k = 0 up to half the sampling rate, else from minus
  /// half of it to below half of it.
  Eigen::Index frequencies(bool is_real) const { return is_real ? length / 2 + 1 : length; }
  /// k of the frequency `index`.
  Eigen::Index harmonic(Eigen::Index index, bool is_real) const {
    return is_real ? index : index - length / 2;
  }
  /// How many independent blocks have a mean square as certain as that of these, for white noise:
  /// fewer where they overlap (Welch 1967, equation 12; Percival & Walden 1993, section 6.17).
  double independent() const;
};

/// Blocks of `length` snapshots of `snapshots`, a share `overlap` of each in the next. The last
/// snapshots, which fill no block, are left out. Throws InputError where not one block is filled,
/// and where a block has fewer than 4 snapshots.
Blocks welch_blocks(Eigen::Index snapshots, Eigen::Index length, double overlap, Taper);

}  // namespace pennon::decomposition

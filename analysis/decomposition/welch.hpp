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
  /// Frequencies 0, 1/(N dt), ...: up to half the sampling rate for real data, else all N, those
  /// above half of it, and half of it, being negative.
  Eigen::Index frequencies(bool is_real) const { return is_real ? length / 2 + 1 : length; }
  double frequency(Eigen::Index index, double dt, bool is_real) const;
  /// How many independent blocks have a mean square as certain as that of these, for white noise:
  /// fewer where they overlap (Welch 1967, equation 12; Percival & Walden 1993, section 6.17).
  double independent() const;
};

/// Blocks of `length` snapshots of `snapshots`, a share `overlap` of each in the next. The last
/// snapshots, which fill no block, are left out. Throws InputError where not one block is filled,
/// and where a block has fewer than 4 snapshots.
Blocks welch_blocks(Eigen::Index snapshots, Eigen::Index length, double overlap, Taper);

}  // namespace pennon::decomposition

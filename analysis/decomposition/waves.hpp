/// Waves along the span of a flag (section 5.1 of Banerjee, Connell & Yue 2015): at one place of
/// the chord
///
///     z(x, t) = Re sum_n zeta_n(t) exp(2 pi i n x/S),
///
/// and each zeta_n as a part that travels along +x and one along -x,
///
///     zeta_n(t) = a_n(t) + b_n(t),
///
/// a_n the part of its Fourier integral with frequencies exp(-i omega t), omega > 0, and b_n that
/// with omega < 0; what does not change with time is in neither. Of a wave A cos(k_x x - omega t)
/// the root mean square of |a_n| is A. The smaller part with as much of the other makes a standing
/// wave; what is left travels.
#pragma once

#include <complex>
#include <vector>

#include "analysis/decomposition/bands.hpp"

namespace pennon::decomposition {

struct SpanwiseWaveParts {
  std::size_t n = 0;
  double k_x = 0;
  std::vector<std::complex<double>> zeta;  ///< at each time
  double along = 0, against = 0;           ///< root mean squares of |a_n|, |b_n|
  /// Most of it swings fewer than three times in the snapshots.
  bool is_short = false;

  double amplitude() const { return along + against; }
  double travelling() const { return along - against; }  ///< > 0: along +x
  double standing() const { return 2 * std::min(along, against); }
};

/// At the points of the chord nearest to y, of each wave that the stations resolve, or in two
/// dimensions of n = 0, whose amplitude is 2^1/2 times the root mean square of what changes. The
/// parts are told apart under Hann's window, so that a series need not hold whole periods. Throws
/// InputError where the data are no flag's.
std::vector<SpanwiseWaveParts> waves(const Bands<double>&, double y);

}  // namespace pennon::decomposition

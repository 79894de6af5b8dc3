/// The wavenumber at which the growth rate is largest.
#pragma once

#include <optional>

#include "common/case/sweep.hpp"
#include "lsa/axes.hpp"
#include "lsa/evaluate.hpp"

namespace pennon::lsa {

struct MostUnstable {
  double wavenumber;
  Stability stability;
  bool is_at_an_end;  ///< of the searched range: the growth may be larger beyond it
};

/// Maximises the growth over `axis` (k_x or k_y), the other parameters as in `point`: the best of
/// the sampled wavenumbers, refined between its neighbours. None where all samples are stable.
/// Throws what solve() throws.
std::optional<MostUnstable> most_unstable(Point point, const Theory&, Axis axis,
                                          const Sweep& search);

}  // namespace pennon::lsa

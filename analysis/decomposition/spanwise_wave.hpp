/// One wave along the span of snapshots at equally spaced stations x_i = i S/N_x:
///
///     q^_n(p, t) = (1/N_x) sum_i q(x_i, p, t) exp(-2 pi i n x_i/S),    q = sum over n of q^_n
///     exp(2 pi i n x/S),
///
/// as complex snapshots of the points p of one station. Their weights are those of all stations
/// together, for 0 < n < N_x/2 of real data twice, for the wave -n: so the variances of all n >= 0
/// add up to that of q.
#pragma once

#include <memory>

#include "analysis/decomposition/snapshots.hpp"

namespace pennon::decomposition {

/// Throws InputError where the data have no span, weights that change with time, or too few
/// stations for the wave; and where they are complex.
std::unique_ptr<Snapshots> spanwise_wave(std::unique_ptr<Snapshots>, std::int64_t n);

}  // namespace pennon::decomposition

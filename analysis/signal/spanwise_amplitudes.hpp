/// The trailing edge as waves along the span (section 5.1 of the paper):
///
///     z(x, t) = Re sum_n zeta_n(t) exp(2 pi i n x/S),
///
/// x the material coordinate s_2 of the stations; zeta_0 is real. A standing wave keeps the phase
/// of zeta_n, a travelling one its modulus.
#pragma once

#include <complex>
#include <vector>

namespace pennon::analysis {

/// A flag whose amplitude stays below this, in L, counts as at rest.
inline constexpr double at_rest = 1e-3;

using Complexes = std::vector<std::complex<double>>;

/// The highest wave kept, or less where the stations resolve less.
inline constexpr std::size_t highest_wave = 7;

/// zeta_n for n = 0 ..., of values [station][row] at equally spaced stations: [n][row].
std::vector<Complexes> spanwise_components(const std::vector<std::vector<double>>& values);

/// The values at a place between stations, x = share S, by the Fourier series that the stations
/// resolve: for each row, of values [station][row].
std::vector<double> between_stations(const std::vector<std::vector<double>>& values, double share);

/// |zeta_n|: [n][row].
std::vector<std::vector<double>> moduli(const std::vector<Complexes>& components);

/// The largest value within `period`/2 of each time: the envelope of an amplitude that swings.
std::vector<double> envelope(const std::vector<double>& t, const std::vector<double>& values,
                             double period);

}  // namespace pennon::analysis

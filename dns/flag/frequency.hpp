/// The frequency of a vibration in one mode, from its samples.
#pragma once

#include <optional>
#include <vector>

namespace pennon::dns {

/// Angular frequency of z(t) = A exp(-d t) cos(omega t + phi), sampled each dt. Prony (1795): with
/// samples k steps apart,
///
///   z(t + k dt) - 2 r cos(theta) z(t) + r^2 z(t - k dt) = 0,   theta = omega k dt,
///   r = exp(-d k dt),
///
/// solved for r and theta by least squares over all triples; k is a quarter of a period, where
/// errors of the samples matter least. Exact for such a vibration but for rounding. None if the
/// samples end before z has changed its sign twice, or do not vibrate.
std::optional<double> angular_frequency(const std::vector<double>& z, double dt);

}  // namespace pennon::dns

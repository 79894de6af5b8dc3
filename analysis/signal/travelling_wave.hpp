/// The angle between the crests of an oblique wave and the span (theta_s and theta_v of the paper's
/// Table 1). Of a wave exp(i(k_x x + k_y y - omega t)) it is
///
///     theta = atan(k_x/k_y).
///
/// A spanwise component zeta_n(t) is a wave along +x or -x by the sense in which it turns; k_y is
/// the change of its phase along y. On the flag this is seen in the shapes, near the trailing edge;
/// in the wake between two probes, up to 2 pi, of which the multiple is taken that comes nearest to
/// a wake carried by the stream, k_y = (omega - k_x U)/V.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/signal/limit_cycle.hpp"
#include "analysis/signal/run_history.hpp"
#include "analysis/signal/spanwise_amplitudes.hpp"

namespace pennon::analysis {

/// A component turning as exp(-i s omega t), s = 1 along +x.
struct Turning {
  std::complex<double> along, against;  ///< amplitudes of exp(-i omega t) and exp(i omega t)
  /// From 0, a standing wave, to 1, a travelling one.
  double excess() const;
  bool is_along_x() const { return std::abs(along) >= std::abs(against); }
};

/// The two amplitudes of values at some times, between the first and the last weighted by Hann's
/// window; omega > 0.
Turning turning_of(const std::vector<double>& t, const Complexes& values, double omega);

/// A wave travels along the span if its excess is above this.
inline constexpr double travels_above = 0.5;

/// Where stations along the chord are at mean y: k_y of the wave whose components there are given,
/// the slope of the straight line through the phases. Neighbours must lie within half a wave.
double chordwise_wavenumber(const std::vector<double>& y, const std::vector<Turning>&);

/// theta in degrees.
double angle_deg(double k_x, double k_y);

struct Angles {
  std::optional<double> theta_s_deg, theta_v_deg;
  std::vector<std::string> notes;
};

/// The angles in a limit cycle. `folder` has the shapes, in shapes.h5; U is the cross-flow.
Angles find_angles(const RunHistory&, const std::vector<Complexes>& components, const LimitCycle&,
                   double U, const std::filesystem::path& folder);

}  // namespace pennon::analysis

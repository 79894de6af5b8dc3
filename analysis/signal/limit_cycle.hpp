/// The limit cycle at the end of a run, in the numbers of the paper's Table 1.
///
///     A     half the range of z of the trailing edge at its antinode, the place along the span
///     where
///           it is largest, at a station or between two; the mean over the last periods
///     f_s   flapping frequency of z there
///     f_v   shedding frequency, of w at the probe nearest to (y, z) = (2, 1/4) L. The paper takes
///           v, which has the same period but a second harmonic that grows toward z = 0
///     St    2 A f_s/V
///     C_D_mean   time average of C_D over the last periods;  C_L_amp   half the range of C_L
///
/// Periods are told by upward passages through the mean (a passage counts when the signal has been
/// below the mean by a fifth of its half range since the last one). The run has a limit cycle if
/// its last periods, 3 at least, agree within 5 % in amplitude and length. It has none where the
/// rows are too few to tell: fewer than eight a period, or so few that what they show is an alias.
/// An alias is known by the flag's kinetic energy, which is then far above that of a flag that
/// swings as a whole with the trailing edge, mu omega^2 <z^2>/2.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "analysis/signal/run_history.hpp"
#include "analysis/signal/series.hpp"
#include "analysis/signal/settings.hpp"

namespace pennon::analysis {

/// One period of a signal.
struct Period {
  double begin = 0, length = 0;
  double amplitude = 0;  ///< half the range
};

/// The last whole periods of a signal, at most `most`, in order of time.
std::vector<Period> last_periods(const std::vector<double>& t, const std::vector<double>& signal,
                                 std::size_t most);

/// The mean frequency of some periods, by the straight line through their beginnings.
double frequency_of(const std::vector<Period>&);

/// By how much the periods differ: (largest - smallest)/mean.
struct Scatter {
  double amplitude = 0, length = 0;
};
Scatter scatter_of(const std::vector<Period>&);

inline constexpr std::size_t fewest_periods_of_cycle = 3;
inline constexpr double periodic_within = 0.05;

struct LimitCycle {
  double A_over_L = 0, f_s = 0, St = 0, C_D_mean = 0, C_L_amp = 0;
  std::optional<double> f_v;
  std::size_t antinode = 0;   ///< the station next to it
  double antinode_share = 0;  ///< its place along the span, in spans
  std::vector<Period> periods;
  double from = 0, to = 0;  ///< the beginning of the first and the end of the last
};

struct LimitCycleResult {
  std::optional<LimitCycle> cycle;
  std::vector<std::string> notes;  ///< why there is none, or no f_v
};

/// The station where the trailing edge swings most in the last third of the run.
std::size_t antinode_of(const RunHistory&);

/// Why the rows between two times do not tell an angular frequency; empty where they do. `mu`: of
/// the flag; 0: an alias is not looked for.
std::string why_rows_are_too_few(const RunHistory&, double from, double to, double omega,
                                 double mu);

/// The probe nearest to where the settings want it; none without probes.
const ProbeHistory* probe_of(const RunHistory&, const Settings&);

LimitCycleResult find_limit_cycle(const RunHistory&, const Settings&, double mu = 0);

}  // namespace pennon::analysis

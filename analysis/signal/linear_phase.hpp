/// The linear phase of a run: how fast its leading mode grows or decays, and when.
///
/// The signal is the leading spanwise component zeta_n of the trailing edge. In a window of time it
/// is fitted by a sum of exponentials (exponentials.hpp), of which the leading one is that with the
/// most energy in the window's later half, among those that swing: the transient of the start has
/// decayed by then, and an offset does not swing. The error is the largest deviation of three fits,
/// to the first, middle and last two thirds of the window.
///
/// Unless the user says it, the window is the longest over which these fits agree: candidates lie
/// in the stretches in which the trailing edge stays within 0.06, 0.03 or 0.01 L of z = 0, or of
/// its mean over the first or the last quarter of the run.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "analysis/signal/run_history.hpp"
#include "analysis/signal/settings.hpp"
#include "analysis/signal/spanwise_amplitudes.hpp"

namespace pennon::analysis {

struct Growth {
  double sigma = 0;  ///< growth rate, in V/L
  double omega = 0;  ///< angular frequency, >= 0, in V/L
  double sigma_error = 0, omega_error = 0;
  double from = 0, to = 0;
  double amplitude = 0;  ///< of the leading mode at `from`, in L
  /// The leading mode's own energy over that of the signal, in the later half without the growth.
  double share = 0;
};

/// The fit in one window; none if the window has fewer than two periods or 16 rows, or no mode
/// holds four fifths of the energy of its later half.
std::optional<Growth> fit_growth(const std::vector<double>& t, const Complexes& signal, double from,
                                 double to);

struct LinearPhase {
  std::optional<Growth> growth;
  std::size_t wave = 0;  ///< n of the component it was found in
  std::string note;      ///< why there is none, or what to mind; a sentence, or empty
};

/// `components` as spanwise_components() gives them; `start`: when the flag begins to move by
/// itself, before which no window is sought.
LinearPhase find_linear_phase(const RunHistory&, const std::vector<Complexes>& components,
                              const Settings&, double start);

}  // namespace pennon::analysis

/// The numbers that steer how the basis and the fits of a map are improved (reduced_map.hpp).
///
/// They weigh the cost of a map against the chance that an error of it stays unseen. None of them
/// says how accurate the map is: that is measured at its points and reported with it. Rates and
/// frequencies are in V/L.
#pragma once

#include <cstddef>

namespace pennon::modes::global {

struct MapHeuristics {
  /// Samples of the response in a window, on the axis of the angular frequency. Seventeen make a
  /// fit to 4e-7 at Re = 1000; one that is not good after several times as many does not converge,
  /// and the map fails with a SolverError.
  std::size_t most_samples = 80;
  /// Samples that the checks of a window may add away from the axis. Each costs a factorisation of
  /// the fluid's equations; where they do not suffice, `lambda_error` reports what is left.
  std::size_t most_samples_off_axis = 40;
  /// A sample that is added is matched so closely that it leaves this share of `lambda_tolerance`.
  /// Less than one, since the fit between samples is worse than at them.
  double share_at_added_sample = 0.1;

  /// Rounds in which the map is found, checked and improved. A map that needs more has a fit or a
  /// basis that does not converge, and its errors report it.
  int most_rounds = 8;
  /// Columns on which the map is improved before it is improved on all. Columns between them need
  /// nearly the same shapes and samples, and a round on few columns costs little.
  std::size_t columns_of_first_rounds = 12;

  /// Distance of the frequencies at which the basis takes its first shapes: the modes that are
  /// neutral within 1 of a frequency (shapes_nearby) then overlap from one to the next.
  double frequency_spacing = 1.5;
  /// Flags whose modes give the first shapes: the first, the last and one between.
  std::size_t flags_of_first_shapes = 3;
  /// The relative error above which a mass ratio in the first basis counts as another one than that
  /// of the whole flag. The shape then is missing; smaller errors are left to the checks.
  double same_mass_ratio = 1e-3;

  /// Points of a window at which lambda in the basis is compared with that of the whole flag. Each
  /// costs one factorisation of the flag's matrix, a few milliseconds at most.
  std::size_t basis_checks = 200;
  /// The share of `lambda_tolerance` up to which the basis may be wrong; the fit has the rest.
  double basis_share = 0.3;
  /// Modes whose shapes are added in a round. Modes that are wrong at neighbouring points lack the
  /// same shapes, so that few of them mend most.
  std::size_t modes_of_round = 4;

  /// The error of lambda up to which a neutral mode in the basis is one of the whole flag without
  /// more ado. Larger than the tolerance of the map, since here only the kind of mode matters.
  double neutral_error = 1e-3;
  /// Beyond it, the mode is one of the whole flag if Newton's method finds one this close to it: in
  /// omega, and relatively in mu.
  double same_neutral_mode = 0.05;

  /// Points among which the next check of the fit is chosen. Each costs one evaluation of the fit
  /// in the basis.
  std::size_t candidates_for_check = 300;
  /// The distance from the next lambda at which the response is known from which on a check tells
  /// the most it can; nearer, its weight falls in proportion.
  double distance_of_news = 0.3;
};

}  // namespace pennon::modes::global

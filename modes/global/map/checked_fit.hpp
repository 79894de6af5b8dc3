/// The fluid's response in a window of the angular frequency as a map uses it: a fit
/// (sampled_fit.hpp), the fit in a basis of the flag's shapes, and the values of the response that
/// were computed to check the map.
#pragma once

#include <vector>

#include "modes/global/map/flag_basis.hpp"
#include "modes/global/map/sampled_fit.hpp"
#include "modes/global/neutral/flag_mode.hpp"

namespace pennon::modes::global {

/// A point of a map, by the index of its flag and of its mass ratio.
struct MapPlace {
  std::size_t column, m;
};

/// The response itself at lambda of a point of the map.
struct ResponseCheck {
  MapPlace at;
  MatrixSample sample;
};

class CheckedFit {
 public:
  CheckedFit(const Interval& window, SampledFit fit)
      : window_(window), fit_(std::move(fit)), small_(fit_.fit), coarse_(fit_.fit) {}

  const Interval& window() const { return window_; }
  const SampledFit& fit() const { return fit_; }
  /// The checks that found lambda right; their values are not part of the fit.
  std::vector<ResponseCheck> checks;
  std::size_t samples_off_axis = 0;  ///< samples that add_off_axis() gave the fit

  /// Projects the fit and its coarser form on the basis.
  void reduce(const FlagBasis&);
  /// The fit in the basis of the last reduce().
  Aerodynamics small() const { return aerodynamics_of(small_); }
  /// SampledFit::coarser() in the basis.
  Aerodynamics coarse() const { return aerodynamics_of(coarse_); }
  /// Whether small() is the fit as it is now: add_off_axis() leaves small() as it was.
  bool is_reduced() const { return is_reduced_; }

  /// F near a sample: the fit plus its error at the sample, so that it agrees with the sample.
  Aerodynamics through(const MatrixSample&) const;
  /// The distance of lambda from the nearest sample of the fit or check.
  double distance_from_known(std::complex<double> lambda) const;
  /// Makes the sample part of the fit, see SampledFit::add.
  void add_off_axis(MatrixSample, double closer, const FlagBasis&);

 private:
  Interval window_;
  SampledFit fit_;
  RationalFit small_, coarse_;
  bool is_reduced_ = false;
};

}  // namespace pennon::modes::global

/// The fluid's response in a window of the angular frequency as a map uses it: a fit
/// (sampled_fit.hpp), its form in a basis of the flag's shapes, and the response itself where it
/// was asked to check the map.
#pragma once

#include <vector>

#include "modes/global/map/flag_basis.hpp"
#include "modes/global/map/sampled_fit.hpp"
#include "modes/global/neutral/flag_mode.hpp"

namespace pennon::modes::global {

/// A point of a map: of which flag, and which mass ratio.
struct MapPlace {
  std::size_t column, m;
};

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
  /// Those at which lambda was right, which are not part of the fit.
  std::vector<ResponseCheck> checks;
  std::size_t samples_off_axis = 0;

  /// For a map that is found with this basis.
  void reduce(const FlagBasis&);
  Aerodynamics small() const { return aerodynamics_of(small_); }
  /// In the basis, of a fit that is a hundred times less close.
  Aerodynamics coarse() const { return aerodynamics_of(coarse_); }
  /// Whether the fit is still that of small().
  bool is_reduced() const { return is_reduced_; }

  /// The response next to where it is known: the fit, moved by what it misses there.
  Aerodynamics through(const MatrixSample&) const;
  /// From the nearest lambda at which it is known, by the fit or a check.
  double distance_from_known(std::complex<double> lambda) const;
  /// See SampledFit::add.
  void add_off_axis(MatrixSample, double closer, const FlagBasis&);

 private:
  Interval window_;
  SampledFit fit_;
  RationalFit small_, coarse_;
  bool is_reduced_ = false;
};

}  // namespace pennon::modes::global

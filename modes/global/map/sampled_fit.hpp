/// F(lambda) of the fluid (aerodynamic_matrix.hpp) as a rational function, from as few samples on
/// the axis of the angular frequency as an error asks for.
#pragma once

#include <functional>
#include <vector>

#include "modes/global/map/rational_fit.hpp"
#include "modes/global/neutral/neutral.hpp"

namespace pennon::modes::global {

Aerodynamics aerodynamics_of(const RationalFit&);

struct SampledFit {
  RationalFit fit;
  /// The largest of |F - fit| over the largest |F|, Frobenius' norms, at the last few samples when
  /// they were not part of the fit: what the fit is worth between samples.
  double error;
  double goal;  ///< the largest error at the samples
  std::vector<MatrixSample> samples;

  Aerodynamics aerodynamics() const { return aerodynamics_of(fit); }
  /// Fits anew, with one sample more that was missed, so much closer to all than that was.
  void add(MatrixSample, double closer);
  /// Of the same samples, a hundred times less close: where it differs most, so may the fit.
  RationalFit coarser() const;
};

using SampleOf = std::function<Eigen::MatrixXcd(std::complex<double> lambda)>;

/// Samples at Chebyshev's points of the interval, then one by one in the middle of two samples,
/// where the last two fits differ most, until `tolerance` holds at three new samples in turn.
/// Throws SolverError where it does not within `most_samples`.
SampledFit sampled_fit(const SampleOf&, const Interval& omega, double tolerance,
                       std::size_t most_samples);

}  // namespace pennon::modes::global

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
  /// The error of the fit between its samples: the largest |F - fit| at the last few samples when
  /// they were not part of the fit yet, over the largest |F|, in Frobenius' norm.
  double error;
  double goal;  ///< the error at the samples that the fit was asked for
  std::vector<MatrixSample> samples;

  Aerodynamics aerodynamics() const { return aerodynamics_of(fit); }
  /// Fits all samples and one more anew, with an error of no more than `closer` times the error
  /// that the present fit has at the new sample.
  void add(MatrixSample, double closer);
  /// A fit to the same samples with a hundred times the error. Where it differs most from this fit,
  /// this fit is most in doubt.
  RationalFit coarser() const;
};

using SampleOf = std::function<Eigen::MatrixXcd(std::complex<double> lambda)>;

/// Samples at Chebyshev's points of the interval, then one by one in the middle of two samples,
/// where the last two fits differ most, until `tolerance` holds at three new samples in succession.
/// Throws SolverError where it does not within `most_samples`.
SampledFit sampled_fit(const SampleOf&, const Interval& omega, double tolerance,
                       std::size_t most_samples);

}  // namespace pennon::modes::global

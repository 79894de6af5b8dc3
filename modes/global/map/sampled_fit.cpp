#include "modes/global/map/sampled_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "common/interrupt.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr int first_samples = 9;
// New samples in succession that must be within the tolerance: one alone may lie where the fit is
// right by chance.
constexpr std::size_t checks_in_succession = 3;
// A smaller error at the samples than this would fit their rounding.
constexpr double least_goal = 1e-11;
// The error at the samples, as a share of the tolerance, which is for the error between them.
constexpr double share_at_samples = 0.1;

std::vector<MatrixSample> all_but_last(std::vector<MatrixSample> samples) {
  samples.pop_back();
  return samples;
}

// The middle of two neighbouring samples at which two fits differ most.
double most_doubtful(const std::vector<MatrixSample>& samples, const RationalFit& a,
                     const RationalFit& b) {
  std::vector<double> omega;
  omega.reserve(samples.size());
  for (const MatrixSample& sample : samples) omega.push_back(sample.lambda.imag());
  std::ranges::sort(omega);
  double doubtful = omega[0], largest = -1;
  for (std::size_t i = 0; i + 1 < omega.size(); ++i) {
    const Complex middle(0, (omega[i] + omega[i + 1]) / 2);
    const double difference = (a(middle) - b(middle)).norm();
    if (difference > largest) {
      largest = difference;
      doubtful = middle.imag();
    }
  }
  return doubtful;
}

}  // namespace

Aerodynamics aerodynamics_of(const RationalFit& fit) {
  return [&fit](Complex lambda) {
    return Response{fit(lambda), [&fit, lambda](const Eigen::VectorXcd& zeta) {
                      return fit.derivative(lambda, zeta);
                    }};
  };
}

void SampledFit::add(MatrixSample sample, double closer) {
  double scale = sample.F.norm();
  for (const MatrixSample& known : samples) scale = std::max(scale, known.F.norm());
  const double missed = (fit(sample.lambda) - sample.F).norm() / scale;
  goal = std::min(goal, std::max(closer * missed, least_goal));
  samples.push_back(std::move(sample));
  fit = RationalFit(samples, goal);
}

RationalFit SampledFit::coarser() const {
  constexpr double times = 100;
  return {samples, times * goal};
}

SampledFit sampled_fit(const SampleOf& F, const Interval& omega, double tolerance,
                       std::size_t most_samples) {
  std::vector<MatrixSample> samples;
  double scale = 0;
  const auto sample = [&](double at) {
    stop_if_interrupted("nothing was written of the fluid's response");
    samples.push_back({Complex(0, at), F(Complex(0, at))});
    scale = std::max(scale, samples.back().F.norm());
  };
  for (int i = 0; i < first_samples; ++i)
    sample((omega.low + omega.high) / 2 -
           (omega.high - omega.low) / 2 * std::cos(std::numbers::pi * i / (first_samples - 1)));
  // The fit before the first check lacks the sample in the middle.
  std::swap(samples[first_samples / 2], samples.back());
  RationalFit before(all_but_last(samples), share_at_samples * tolerance);
  RationalFit now(samples, share_at_samples * tolerance);
  std::vector<double> errors;
  while (samples.size() < most_samples) {
    sample(most_doubtful(samples, before, now));
    const MatrixSample& check = samples.back();
    errors.push_back((now(check.lambda) - check.F).norm() / scale);
    before = now;
    now = RationalFit(samples, share_at_samples * tolerance);
    if (errors.size() < checks_in_succession) continue;
    const double error = *std::max_element(errors.end() - checks_in_succession, errors.end());
    if (error <= tolerance) return {now, error, share_at_samples * tolerance, std::move(samples)};
  }
  throw SolverError(fmt::format(
      "the fluid's response for angular frequencies from {:.4g} to {:.4g} was not fitted to {:.1e} "
      "by {} samples: the last was missed by {:.2e}; a narrower range of omega or a larger "
      "fit_tolerance may help",
      omega.low, omega.high, tolerance, most_samples, errors.empty() ? 1.0 : errors.back()));
}

}  // namespace pennon::modes::global

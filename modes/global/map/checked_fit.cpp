#include "modes/global/map/checked_fit.hpp"

#include <algorithm>
#include <limits>

namespace pennon::modes::global {

using Complex = std::complex<double>;

void CheckedFit::reduce(const FlagBasis& basis) {
  small_ = basis.reduced(fit_.fit);
  coarse_ = basis.reduced(fit_.coarser());
  is_reduced_ = true;
}

Aerodynamics CheckedFit::through(const MatrixSample& sample) const {
  const Eigen::MatrixXcd missed = sample.F - fit_.fit(sample.lambda);
  return [&fit = fit_.fit, missed](Complex lambda) {
    return Response{fit(lambda) + missed, [&fit, lambda](const Eigen::VectorXcd& zeta) {
                      return fit.derivative(lambda, zeta);
                    }};
  };
}

double CheckedFit::distance_from_known(Complex lambda) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const MatrixSample& known : fit_.samples)
    nearest = std::min(nearest, std::abs(known.lambda - lambda));
  for (const ResponseCheck& check : checks)
    nearest = std::min(nearest, std::abs(check.sample.lambda - lambda));
  return nearest;
}

void CheckedFit::add_off_axis(MatrixSample sample, double closer, const FlagBasis& basis) {
  fit_.add(std::move(sample), closer);
  coarse_ = basis.reduced(fit_.coarser());
  ++samples_off_axis;
  is_reduced_ = false;
}

}  // namespace pennon::modes::global

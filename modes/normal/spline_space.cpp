#include "modes/normal/spline_space.hpp"

#include <cassert>
#include <unsupported/Eigen/Splines>

namespace pennon::modes {
namespace {

using Spline = Eigen::Spline<Extended, 1, SplineSpace::degree>;

}  // namespace

SplineSpace::SplineSpace(std::vector<double> breaks) : breaks_(std::move(breaks)) {
  assert(breaks_.size() >= 2 && breaks_.front() == 0 && breaks_.back() == 1);
  const auto count = static_cast<Eigen::Index>(breaks_.size());
  knots_.resize(count + 2 * Eigen::Index{degree});
  knots_.head(degree).setConstant(0);
  knots_.tail(degree).setConstant(1);
  for (Eigen::Index i = 0; i < count; ++i)
    knots_[degree + i] = breaks_[static_cast<std::size_t>(i)];
}

SplineSpace::Local SplineSpace::at(double y) const {
  return {Spline::Span(y, degree, knots_) - degree,
          Spline::BasisFunctionDerivatives(y, 2, degree, knots_)};
}

double SplineSpace::value(const ExtendedVector& coefficients, double y) const {
  const Eigen::Index first = Spline::Span(y, degree, knots_) - degree;
  const Spline::BasisVectorType functions = Spline::BasisFunctions(y, degree, knots_);
  return static_cast<double>(
      functions.matrix().dot(coefficients.segment(first, functions_per_element).transpose()));
}

}  // namespace pennon::modes

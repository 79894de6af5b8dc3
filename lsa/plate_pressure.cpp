#include "lsa/plate_pressure.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::lsa {
namespace {

constexpr double forgotten =
    20;  // e-foldings after which the start of the Riccati equation is lost
constexpr double tolerance = 1e-13;

struct Radial {
  double lambda;
  double k_x;
  double start;  // rho where the integration begins

  double stiffness(double rho) const {
    const double s = k_x / 2 * std::sinh(rho);
    return lambda + s * s;
  }
};

// sigma = -g'/g at the strip. The distance from the start is the independent variable.
double decay_rate(double lambda, double k_x) {
  if (k_x == 0) return std::sqrt(lambda);
  Radial radial{lambda, k_x, 0};
  radial.start = std::min(forgotten / std::sqrt(lambda), std::acosh(1 + 2 * forgotten / k_x));
  const auto slope = [](double distance, const double* sigma, double* d_sigma, void* p) -> int {
    const Radial& r = *static_cast<const Radial*>(p);
    d_sigma[0] = r.stiffness(r.start - distance) - sigma[0] * sigma[0];
    return GSL_SUCCESS;
  };
  gsl_odeiv2_system system{slope, nullptr, 1, &radial};
  double sigma = std::sqrt(radial.stiffness(radial.start));
  const std::unique_ptr<gsl_odeiv2_driver, void (*)(gsl_odeiv2_driver*)> driver(
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1e-3 / sigma, 0, tolerance),
      gsl_odeiv2_driver_free);
  double distance = 0;
  if (const int status = gsl_odeiv2_driver_apply(driver.get(), &distance, radial.start, &sigma))
    throw SolverError(fmt::format("the pressure on a plate at k_x = {}: {} at rho = {:.3g}", k_x,
                                  gsl_strerror(status), radial.start - distance));
  return sigma;
}

// The operator -d^2/dtheta^2 + (k_x^2/4) sin^2(theta) on sin(n theta), n = 1..terms.
Eigen::MatrixXd angular_operator(double k_x, int terms) {
  Eigen::MatrixXd op = Eigen::MatrixXd::Zero(terms, terms);
  const double eighth = k_x * k_x / 8;
  for (int i = 0; i < terms; ++i) {
    op(i, i) = (i + 1.0) * (i + 1.0) + eighth;
    if (i + 2 < terms) op(i, i + 2) = op(i + 2, i) = -eighth / 2;
  }
  op(0, 0) += eighth / 2;  // cos(2 theta) sin(theta) holds -sin(theta)/2
  return op;
}

}  // namespace

PlatePressure::PlatePressure(double k_x, int terms) {
  const double k = std::abs(k_x);
  if (!(k <= largest_wavenumber))
    throw SolverError(fmt::format(
        "the pressure on a plate is computed for |k_x| up to {}, not {}; there it is 2/k_x times "
        "the acceleration to within 1 %: take the added mass lamb",
        largest_wavenumber, k_x));
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> angular(angular_operator(k, terms));
  const Eigen::MatrixXd& q = angular.eigenvectors();
  const Eigen::VectorXd sigma =
      angular.eigenvalues().unaryExpr([k](double lambda) { return decay_rate(lambda, k); });
  compliance_ = 2 * q * sigma.cwiseInverse().asDiagonal() * q.transpose();
}

Eigen::VectorXd PlatePressure::opposing(const std::function<double(double)>& acceleration) const {
  // Sine coefficients of psi_rho = 1/2 sin(theta) a by the trapezoidal rule, exact for what the
  // sines resolve.
  const Eigen::Index terms = compliance_.rows();
  const Eigen::Index points = 2 * terms + 2;
  Eigen::VectorXd sines = Eigen::VectorXd::Zero(terms);
  for (Eigen::Index i = 1; i < points; ++i) {
    const double theta = std::numbers::pi * static_cast<double>(i) / static_cast<double>(points);
    const double slope = 0.5 * std::sin(theta) * acceleration((1 + std::cos(theta)) / 2);
    for (Eigen::Index n = 0; n < terms; ++n)
      sines[n] +=
          2.0 / static_cast<double>(points) * slope * std::sin(static_cast<double>(n + 1) * theta);
  }
  return compliance_ * sines;
}

}  // namespace pennon::lsa

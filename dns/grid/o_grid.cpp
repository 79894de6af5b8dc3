#include "dns/grid/o_grid.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::dns {
namespace {

constexpr double least_growth = 0.5, most_growth = 2;

// (g^n - 1)/(g - 1), the length of n cells of which the first has length 1.
double geometric_sum(double growth, int n) {
  double sum = 0;
  for (int j = n; j > 0; --j) sum = sum * growth + 1;
  return sum;
}

// The ratio with which n cells of first length 1 have the length `total`.
double growth_for(double total, int n) {
  double low = least_growth, high = most_growth;
  constexpr int halvings = 80;
  for (int k = 0; k < halvings; ++k) {
    const double middle = (low + high) / 2;
    (geometric_sum(middle, n) < total ? low : high) = middle;
  }
  return (low + high) / 2;
}

}  // namespace

OGrid::OGrid(const OGridSettings& settings) : settings_(settings) {
  const int n_rho = settings.n_rho, n_theta = settings.n_theta;
  const double rho_max = std::asinh(2 * settings.R);
  const double total = rho_max / settings.wall_spacing;
  if (total < geometric_sum(least_growth, n_rho) || total > geometric_sum(most_growth, n_rho))
    throw InputError(
        "dns.wall_spacing",
        fmt::format("= {} does not reach dns.R = {} with dns.n_rho = {} cells that grow by 0.5 to "
                    "2 from one to the next; uniform cells would have {:.3g}",
                    settings.wall_spacing, settings.R, n_rho, rho_max / n_rho));
  growth_ = growth_for(total, n_rho);
  rho_.resize(static_cast<std::size_t>(n_rho) + 1, 0.0);
  for (int j = 1; j <= n_rho; ++j)
    rho_[static_cast<std::size_t>(j)] =
        rho_max * geometric_sum(growth_, j) / geometric_sum(growth_, n_rho);
  theta_.resize(static_cast<std::size_t>(n_theta) + 1);
  for (int i = 0; i <= n_theta; ++i) {
    const double t = 2 * std::numbers::pi * i / n_theta;
    theta_[static_cast<std::size_t>(i)] = t - settings.wake_clustering * std::sin(t);
  }
  for (int j = 0; j <= n_rho; ++j) {
    along_rho_.cosh.push_back(std::cosh(rho(j)));
    along_rho_.sinh.push_back(std::sinh(rho(j)));
    along_rho_.face_step.push_back(rho_face_step(j));
    if (j == n_rho) continue;
    along_rho_.cosh_centre.push_back(std::cosh(rho_centre(j)));
    along_rho_.sinh_centre.push_back(std::sinh(rho_centre(j)));
    along_rho_.cosh_half_step.push_back(std::cosh(rho_step(j) / 2));
    along_rho_.sinh_half_step.push_back(std::sinh(rho_step(j) / 2));
    along_rho_.step.push_back(rho_step(j));
  }
  for (int i = 0; i <= n_theta; ++i) {
    along_theta_.cos.push_back(std::cos(theta(i)));
    along_theta_.sin.push_back(std::sin(theta(i)));
    along_theta_.face_step.push_back(theta_face_step(i));
    if (i == n_theta) continue;
    along_theta_.cos_centre.push_back(std::cos(theta_centre(i)));
    along_theta_.sin_centre.push_back(std::sin(theta_centre(i)));
    along_theta_.cos_half_step.push_back(std::cos(theta_step(i) / 2));
    along_theta_.sin_half_step.push_back(std::sin(theta_step(i) / 2));
    along_theta_.step.push_back(theta_step(i));
  }
}

double OGrid::rho_face_step(int j) const {
  if (j == 0) return 3 * rho_centre(0) - rho_centre(1) / 3;
  if (j == n_rho()) return 2 * (rho(j) - rho_centre(j - 1));
  return rho_centre(j) - rho_centre(j - 1);
}

double OGrid::theta_face_step(int i) const {
  if (i == 0 || i == n_theta()) return (theta_step(0) + theta_step(n_theta() - 1)) / 2;
  return theta_centre(i) - theta_centre(i - 1);
}

std::complex<double> OGrid::place(double rho, double theta) {
  return 0.5 + 0.5 * std::cosh(std::complex<double>(rho, theta));
}

std::complex<double> OGrid::slope(double rho, double theta) {
  return 0.5 * std::sinh(std::complex<double>(rho, theta));
}

}  // namespace pennon::dns

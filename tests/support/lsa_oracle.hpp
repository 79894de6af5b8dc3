/// The dispersion relation (4.6) in 50 digits, from the printed formulas without any rearrangement:
/// what pennon's double precision is judged by. Also how far rounding may lead a double there.
#pragma once

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <optional>
#include <random>

#include "lsa/dispersion.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa::oracle {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                           boost::multiprecision::et_off>;

/// A point whose span may be given by gamma, as a user gives it.
struct Sample {
  Point point;
  std::optional<double> gamma;
};

struct Exact {
  Real c_m, P, D, s, K, drift, total_mass, root_of_D;
  std::optional<Real> mu_cr;

  Real omega_r(int sign) const {
    return D < 0 ? drift / total_mass : (drift + sign * root_of_D) / total_mass;
  }
  Real omega_i(int sign) const { return D < 0 ? sign * root_of_D / total_mass : Real(0); }
};

inline Exact solve(const Sample& sample, const Model& model) {
  const Point& p = sample.point;
  const Real& pi = boost::math::constants::pi<Real>();
  const Real k_x = sample.gamma ? 2 * pi / Real(*sample.gamma) : Real(p.k_x);
  const Real k_y = p.k_y;
  const Real tau = Real(model.tension_coefficient) / sqrt(Real(p.Re));
  const Real k_squared = k_x * k_x + k_y * k_y;
  Exact e;
  switch (model.added_mass) {
    case AddedMass::two_d:
      e.c_m = 2 / k_y;
      break;
    case AddedMass::lamb:
      e.c_m = 2 / sqrt(k_squared);
      break;
    default:
      e.c_m = k_x == 0 ? Real(2 / k_y) : Real(pi / 4 * (2 * pi / abs(k_x)));
      break;
  }
  e.K = tau * (k_y * k_y + Real(p.nu_s) * k_x * k_x);
  if (model.bending) e.K += Real(p.K_B) * k_squared * k_squared;
  const Real kappa = model.cross_flow ? Real(k_y + Real(p.U) * k_x) : k_y;
  const Real mu = p.mu;
  e.drift = e.c_m * kappa;
  e.total_mass = mu + e.c_m;
  e.s = e.c_m * kappa * kappa - e.K;
  e.D = e.total_mass * e.K - mu * e.c_m * kappa * kappa;
  e.P = e.D / (e.drift * e.drift);
  e.root_of_D = sqrt(abs(e.D));
  if (e.s > 0) e.mu_cr = e.c_m * e.K / e.s;
  return e;
}

/// First-order bounds of the rounding error for relative perturbations of size `unit` of each
/// operand: no formula in double precision can promise less.
struct Conditioning {
  double D;          ///< absolute error of D
  double s;          ///< absolute error of s
  double root_of_D;  ///< absolute error of D^1/2, also where D may change sign
  double drift;      ///< absolute error of c_m kappa
};

inline Conditioning conditioning(const Sample& sample, const Model& model, const Exact& e,
                                 double unit) {
  const Point& p = sample.point;
  const double c_m = static_cast<double>(e.c_m);
  const double K = static_cast<double>(e.K);
  const double k_x = sample.gamma ? 2 * std::numbers::pi / *sample.gamma : p.k_x;
  const double kappa_parts = p.k_y + (model.cross_flow ? std::abs(p.U * k_x) : 0.0);
  const double inflow = c_m * kappa_parts * kappa_parts;
  Conditioning bound{};
  bound.s = unit * (inflow + K);
  bound.D = unit * (c_m * K + p.mu * (inflow + K));
  const double root = static_cast<double>(e.root_of_D);
  bound.root_of_D = std::min(root > 0 ? bound.D / root : HUGE_VAL, std::sqrt(2 * bound.D));
  bound.drift = unit * c_m * kappa_parts;
  return bound;
}

/// Random parameters, each logarithmic over the whole range that the theory is asked to survive.
class Sampler {
 public:
  explicit Sampler(std::uint64_t seed) : random_(seed) {}

  Sample operator()() {
    Sample sample;
    Point& p = sample.point;
    p.Re = log_uniform(-3, 12);
    p.mu = log_uniform(-12, 12);
    p.k_y = log_uniform(-8, 8);
    p.nu_s = 0.5 * uniform_(random_);
    const double which = uniform_(random_);
    if (which < 0.1)
      p.k_x = 0;
    else if (which < 0.55)
      p.k_x = log_uniform(-8, 8);
    else {
      sample.gamma = log_uniform(-6, 6);
      p.k_x = 2 * std::numbers::pi / *sample.gamma;
    }
    p.K_B = uniform_(random_) < 0.2 ? 0 : log_uniform(-12, 4);
    p.U = uniform_(random_) < 0.2 ? 0 : (uniform_(random_) < 0.5 ? -1 : 1) * log_uniform(-3, 1);
    return sample;
  }

 private:
  double log_uniform(double low, double high) {
    return std::pow(10.0, low + (high - low) * uniform_(random_));
  }
  std::mt19937_64 random_;
  std::uniform_real_distribution<double> uniform_{0, 1};
};

}  // namespace pennon::lsa::oracle

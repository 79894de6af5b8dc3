/// The local dispersion relation of a flag in a stream (Banerjee, Connell & Yue 2015, section 4).
///
///   (4.6)  (mu + c_m) omega^2 - 2 c_m kappa omega + c_m kappa^2 - K = 0,
///          the same as  mu omega^2 + c_m (omega - kappa)^2 = K,
///   with   K = A + B [+ K_B (k_x^2 + k_y^2)^2],  A = nu_s tau k_x^2,  B = tau k_y^2,
///          tau = 1.3 Re^-1/2,  kappa = k_y [+ U k_x].
///
/// The bracketed terms are off unless the model switches them on. With
///
///   D = c_m K - mu s,   s = c_m kappa^2 - K,
///
/// the roots (4.7) are omega = (c_m kappa +- sqrt(D))/(mu + c_m) and P = D/(c_m kappa)^2. K is a
/// sum of terms that are not negative, so the only subtractions that can cancel are s (where the
/// critical mass ratio leaves for infinity), D (the neutral curve) and kappa. Where the roots are
/// real, the smaller one is taken from their product s/(mu + c_m), which loses nothing.
#pragma once

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <optional>

#include "lsa/model.hpp"

namespace pennon::lsa {

/// The numbers of (4.6).
struct Coefficients {
  double mu;
  double c_m;
  double kappa;  ///< k_y, with cross-flow k_y + U k_x
  double K;      ///< all restoring forces
  double B;      ///< the part of K by chordwise tension; (4.8b) as printed has its sign wrong
};

/// `c_m` from added_mass(); `tension` from tension_times_sqrt_Re().
inline Coefficients coefficients(const Point& p, double c_m, double tension, bool bending,
                                 bool cross_flow) {
  const double tau = tension / std::sqrt(p.Re);
  const double k_x_squared = p.k_x * p.k_x;
  const double k_y_squared = p.k_y * p.k_y;
  const double B = tau * k_y_squared;
  double K = p.nu_s * tau * k_x_squared + B;
  if (bending) {
    const double k_squared = k_x_squared + k_y_squared;
    K += p.K_B * k_squared * k_squared;
  }
  return {p.mu, c_m, cross_flow ? p.k_y + p.U * p.k_x : p.k_y, K, B};
}

/// The roots of (4.6) and what follows from them. Angular frequencies are in V/L.
struct Stability {
  double c_m;
  double P;                             ///< of (4.7); unstable where negative
  double omega_r_plus, omega_i_plus;    ///< the root with +P^1/2; if complex, the one that grows
  double omega_r_minus, omega_i_minus;  ///< the other root
  double growth;                        ///< max Im omega, 0 where both roots are real; (4.9)
  double frequency;                     ///< Re omega/(2 pi) of the plus root, in V/L
  double mu_cr;                         ///< (4.8b); NaN where no mass ratio is unstable

  bool is_unstable() const { return P < 0; }
  std::complex<double> omega_plus() const { return {omega_r_plus, omega_i_plus}; }
  std::complex<double> omega_minus() const { return {omega_r_minus, omega_i_minus}; }
};

/// Solves (4.6). It selects instead of branching and divides no more than needed, so that a loop
/// over points becomes vector code; single points and maps share it and agree to the bit.
/// docs/accuracy.md states its accuracy.
template <Form form>
Stability solve(const Coefficients& c) {
  const double total_mass = c.mu + c.c_m;
  const double drift = c.c_m * c.kappa;
  const double s = drift * c.kappa - c.K;
  const double D = c.c_m * c.K - c.mu * s;
  const double root_of_D = std::sqrt(std::abs(D));
  const bool is_unstable = D < 0;

  // Complex roots: center +- i width. Real roots: q has no cancellation, so q/total_mass is the
  // large root, and s/q the other; q is 0 only where both roots are.
  const double q = drift + std::copysign(root_of_D, drift);
  const double center_or_large = (is_unstable ? drift : q) / total_mass;
  const double width_or_small =
      (is_unstable ? root_of_D : s) / (is_unstable ? total_mass : (q != 0 ? q : 1.0));
  const bool large_is_plus = drift >= 0;

  Stability result{};
  result.c_m = c.c_m;
  result.P = D / (drift * drift);
  result.omega_r_plus = is_unstable || large_is_plus ? center_or_large : width_or_small;
  result.omega_r_minus = is_unstable || !large_is_plus ? center_or_large : width_or_small;
  result.omega_i_plus = is_unstable ? width_or_small : 0.0;
  result.omega_i_minus = -result.omega_i_plus;
  result.growth = result.omega_i_plus;
  if constexpr (form == Form::as_printed)  // (4.9) as printed: (-P)^1/2
    result.growth = is_unstable ? root_of_D / std::abs(drift) : 0.0;
  result.frequency = result.omega_r_plus * (0.5 * std::numbers::inv_pi);
  const double margin = form == Form::as_printed ? s + 2 * c.B : s;
  result.mu_cr = margin > 0 ? c.c_m * c.K / margin : std::numeric_limits<double>::quiet_NaN();
  return result;
}

inline Stability solve(const Coefficients& c, Form form) {
  return form == Form::consistent ? solve<Form::consistent>(c) : solve<Form::as_printed>(c);
}

/// A function with the sign of P that is finite wherever the coefficients are, for tracing P = 0.
inline double neutral_function(const Coefficients& c) {
  const double m = c.mu / c.c_m;
  return c.K / c.c_m - m * (c.kappa * c.kappa - c.K / c.c_m);
}

}  // namespace pennon::lsa

/// A plate that plunges or pitches a little in the stream, and Theodorsen's theory of it.
#pragma once

#include <gsl/gsl_sf_bessel.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "tests/support/fluids.hpp"

namespace pennon::test {

using Complex = std::complex<double>;

// Theodorsen (1935): lift and nose-up moment about mid-chord of a plate of chord 1 in the stream 1,
// times exp(i omega t); the plunge is counted downward, the pitch nose-up about mid-chord.
struct LiftAndMoment {
  Complex lift, moment;
};
inline Complex theodorsen_function(double k) {
  const Complex H0(gsl_sf_bessel_J0(k), -gsl_sf_bessel_Y0(k));
  const Complex H1(gsl_sf_bessel_J1(k), -gsl_sf_bessel_Y1(k));
  return H1 / (H1 + Complex(0, 1) * H0);
}
inline LiftAndMoment theodorsen(double omega, Complex plunge, Complex pitch) {
  constexpr double b = 0.5;  // half the chord
  const Complex D(0, omega);
  const Complex downwash = D * plunge + pitch + b / 2 * D * pitch;
  const Complex circulatory = 2 * std::numbers::pi * b * theodorsen_function(omega * b) * downwash;
  return {std::numbers::pi * b * b * (D * D * plunge + D * pitch) + circulatory,
          std::numbers::pi * b * b * (-b / 2 * D * pitch - b * b / 8 * D * D * pitch) +
              b / 2 * circulatory};
}

// Over Theodorsen's: by tone.
struct Ratios {
  std::vector<Complex> lift, moment;
};

// All tones at once, which small amplitudes allow; their common period is the time over which the
// forces are taken apart.
inline Ratios measure(const FluidCase& settings, const std::vector<double>& omegas, double period,
                      double dt_wanted, bool pitches) {
  const int steps_of_period = static_cast<int>(std::lround(period / dt_wanted));
  const double dt = period / steps_of_period;
  constexpr double downwash = 0.01;
  const auto amplitude = [&](double omega) { return downwash / (pitches ? 1 + omega / 4 : omega); };
  FluidRun run(settings, [&](double t, double, double y) -> std::array<double, 2> {
    const double begun = t < 0.5 ? std::pow(std::sin(std::numbers::pi * t), 2) : 1.0;
    double sum = 0;
    for (const double omega : omegas) sum += begun * amplitude(omega) * std::sin(omega * t);
    return {0, pitches ? -sum * (y - 0.5) : -sum};
  });
  run.run_to(steps_of_period * dt, dt);  // the start's vortex goes
  Ratios found{std::vector<Complex>(omegas.size()), std::vector<Complex>(omegas.size())};
  for (int n = 0; n < steps_of_period; ++n) {
    run.step(dt);
    const dns::WallTraction traction = run.traction();
    double lift = 0, moment = 0;
    for (int i = 0; i < run.grid().n_theta(); ++i) {
      const double y = (1 + std::cos(run.grid().theta_centre(i))) / 2;
      const double force = traction.force[2][static_cast<std::size_t>(i)];
      lift += force;
      moment -= (y - 0.5) * force;
    }
    for (std::size_t k = 0; k < omegas.size(); ++k) {
      const Complex tone =
          2.0 / steps_of_period * Complex(0, 1) * std::exp(Complex(0, -omegas[k] * run.state().t));
      found.lift[k] += lift * tone;
      found.moment[k] += moment * tone;
    }
  }
  for (std::size_t k = 0; k < omegas.size(); ++k) {
    const double q = amplitude(omegas[k]);
    const LiftAndMoment exact = theodorsen(omegas[k], pitches ? 0 : q, pitches ? q : 0);
    found.lift[k] /= exact.lift;
    found.moment[k] /= exact.moment;
  }
  return found;
}

inline FluidCase oscillating_plate(double Re, int n_rho) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, 8, 24 / (n_rho * std::sqrt(Re)), 0};
  settings.parameters = {Re, 0};
  settings.tolerances.grid = 1e-8;
  settings.tolerances.pressure = 1e-7;
  return settings;
}

}  // namespace pennon::test

// Forces on a plate that moves a little, against potential flow.
#include <gsl/gsl_sf_bessel.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "lsa/plate_pressure.hpp"
#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
constexpr double pi = std::numbers::pi;

FluidCase plate(int n_rho, double Re) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, 8, 0.72 / n_rho, 0};
  settings.parameters = {Re, 0};
  settings.tolerances = {1e-10, 1e-11, 1e-9, 20};
  return settings;
}

constexpr double acceleration = 0.01;  // so small that the plate's place does not matter
constexpr double step = 1e-5;
constexpr int steps = 10;

// The force per span against a plate that begins to plunge, over its acceleration cos(k_x x), at x
// = 0.
double added_mass(const FluidCase& settings, double k_x) {
  FluidRun run(settings, [k_x](double t, double x, double) -> std::array<double, 2> {
    return {0, acceleration * t * t / 2 * std::cos(k_x * x)};
  });
  for (int n = 0; n < steps; ++n) run.step(step);
  return -station_force(run.fluid(), run.traction(), 0)[2] / acceleration;
}

// A plunging plate carries pi/4 of fluid per span, and more by the layer that friction has set in
// motion, whose share is as (t/Re)^1/2. (The circulation that begins adds 2 t = 2e-4 of it.)
TEST(AddedMass, OfAPlungingPlateIsAQuarterOfPi) {
  const double slow = added_mass(plate(60, 1e3), 0), middle = added_mass(plate(60, 4e3), 0),
               fast = added_mass(plate(60, 16e3), 0);
  EXPECT_NEAR((slow - middle) / (middle - fast), 2, 0.1);
  const double inviscid = 2 * fast - middle;
  EXPECT_NEAR(inviscid / (pi / 4), 1, 0.005);
  // On the coarser grid the error is as small; it is of the edges' last cells.
  EXPECT_NEAR(added_mass(plate(30, 1e8), 0) / (pi / 4), 1, 0.005);
}

// Acceleration as cos(k_x x): the separable solution of linear potential flow, of which the first
// sine makes the force.
TEST(AddedMass, OfAPlungingWaveIsThatOfPotentialFlow) {
  for (const double k_x : {1.0, 2 * pi, 20.0}) {
    const double exact =
        pi / 4 * lsa::PlatePressure(k_x, 40).opposing([](double) { return 1.0; })[0];
    std::array<double, 2> error{};
    for (std::size_t n = 0; n < 2; ++n) {
      FluidCase settings = plate(n == 0 ? 30 : 60, 1e8);
      settings.planes = 4;  // enough for one harmonic
      settings.span = 2 * pi / k_x;
      error[n] = std::abs(added_mass(settings, k_x) / exact - 1);
    }
    // At 20 the pressure falls off within a few cells of the wall.
    EXPECT_LT(error[1], k_x < 10 ? 0.0005 : 0.005) << k_x;
    EXPECT_GT(std::log2(error[0] / error[1]), 0.9) << k_x;
  }
}

using Complex = std::complex<double>;

// Theodorsen (1935): lift and nose-up moment about mid-chord of a plate of chord 1 in the stream 1,
// times exp(i omega t); the plunge is counted downward, the pitch nose-up about mid-chord.
struct LiftAndMoment {
  Complex lift, moment;
};
Complex theodorsen_function(double k) {
  const Complex H0(gsl_sf_bessel_J0(k), -gsl_sf_bessel_Y0(k));
  const Complex H1(gsl_sf_bessel_J1(k), -gsl_sf_bessel_Y1(k));
  return H1 / (H1 + Complex(0, 1) * H0);
}
LiftAndMoment theodorsen(double omega, Complex plunge, Complex pitch) {
  constexpr double b = 0.5;
  const Complex D(0, omega);
  const Complex downwash = D * plunge + pitch + b / 2 * D * pitch;
  const Complex circulatory = 2 * pi * b * theodorsen_function(omega * b) * downwash;
  return {pi * b * b * (D * D * plunge + D * pitch) + circulatory,
          pi * b * b * (-b / 2 * D * pitch - b * b / 8 * D * D * pitch) + b / 2 * circulatory};
}

// Over Theodorsen's: by tone.
struct Ratios {
  std::vector<Complex> lift, moment;
};

// All tones at once, which small amplitudes allow; their common period is the time over which the
// forces are taken apart.
Ratios measure(const FluidCase& settings, const std::vector<double>& omegas, double period,
               double dt_wanted, bool pitches) {
  const int steps_of_period = static_cast<int>(std::lround(period / dt_wanted));
  const double dt = period / steps_of_period;
  constexpr double downwash = 0.01;
  const auto amplitude = [&](double omega) { return downwash / (pitches ? 1 + omega / 4 : omega); };
  FluidRun run(settings, [&](double t, double, double y) -> std::array<double, 2> {
    const double begun = t < 0.5 ? std::pow(std::sin(pi * t), 2) : 1.0;
    double sum = 0;
    for (const double omega : omegas) sum += begun * amplitude(omega) * std::sin(omega * t);
    return {0, pitches ? -sum * (y - 0.5) : -sum};
  });
  run.run_to(steps_of_period * dt, dt);  // the start's vortex goes
  Ratios found{std::vector<Complex>(omegas.size()), std::vector<Complex>(omegas.size())};
  for (int n = 0; n < steps_of_period; ++n) {
    run.step(dt);
    const WallTraction traction = run.traction();
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

FluidCase oscillating_plate(double Re, int n_rho) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, 8, 24 / (n_rho * std::sqrt(Re)), 0};
  settings.parameters = {Re, 0};
  settings.tolerances.grid = 1e-8;
  settings.tolerances.pressure = 1e-7;
  return settings;
}

// The lift of a plate that plunges or pitches is Theodorsen's less what friction makes of the
// trailing edge, which goes about as Re^-1/4: least where the added mass prevails. Reduced
// frequencies 2 and 5.
TEST(OscillatingPlate, TendsToTheodorsensLiftAsFrictionGoes) {
  for (const bool pitches : {false, true}) {
    const auto ratios = [pitches](double Re) {
      return measure(oscillating_plate(Re, 48), {4, 10}, pi, 0.01, pitches).lift;
    };
    const std::vector<Complex> slow = ratios(1000), fast = ratios(4000);
    // Bounds: what was measured, 0.11 and 0.08 in plunge, 0.26 and 0.37 in pitch, and a margin.
    const double most = pitches ? 0.4 : 0.13;
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LT(std::abs(slow[k] - 1.0), most) << pitches << k;
      EXPECT_LT(std::abs(fast[k] - 1.0), 0.85 * std::abs(slow[k] - 1.0)) << pitches << k;
    }
  }
}

}  // namespace
}  // namespace pennon::dns

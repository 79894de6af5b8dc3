// Forces on a plate that moves a little, against potential flow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "lsa/plate_pressure.hpp"
#include "tests/support/oscillating_plate.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

FluidCase plate(int n_rho, double Re) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, 8, 0.72 / n_rho, 0};
  settings.parameters = {Re, 0};
  settings.tolerances = {1e-10, 1e-11, 1e-9, 20};
  return settings;
}

constexpr double acceleration = 100;  // over so short a time that the plate keeps its place
constexpr double step = 1e-5;
constexpr int steps = 10;

// The force per span against a plate that begins to plunge, over its acceleration cos(k_x x), at x
// = 0.
double added_mass(const FluidCase& settings, double k_x) {
  FluidRun run(settings, [k_x](double t, double x, double) -> std::array<double, 2> {
    return {0, acceleration * t * t / 2 * std::cos(k_x * x)};
  });
  for (int n = 0; n < steps; ++n) run.step(step);
  return -plane_force(run.fluid(), run.traction(), 0)[2] / acceleration;
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
    EXPECT_LT(error[1], std::max(0.5 * error[0], 1e-4)) << k_x;
  }
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

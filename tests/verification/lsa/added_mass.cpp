/// Added masses against potential theory that the code does not use.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_sf_bessel.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

#include "common/errors.hpp"
#include "lsa/added_mass.hpp"
#include "lsa/plate_pressure.hpp"

namespace pennon::lsa {
namespace {

using std::numbers::pi;
constexpr double quadrature = 1e-10;  // ten times the tolerance of minami()

double plate(MinamiMode mode, double k_x, double k_y = pi) {
  return minami({mode, MinamiPressure::plate}, k_x, k_y);
}

TEST(AddedMass, OfLambTendsToThePlaneWaveAsTheSpanGrows) {
  EXPECT_NEAR(added_mass(AddedMass::lamb, {}, 1e-9, 2), 2.0 / 2, 1e-15);
  EXPECT_EQ(added_mass(AddedMass::two_d, {}, 5, 2), 1);
}

TEST(AddedMass, OfWuIsThatOfAPlungingChordTimesTheSpan) {
  EXPECT_NEAR(added_mass(AddedMass::wu, {}, 2 * pi / 3, 1), pi * 3 / 4, 1e-15);
}

TEST(AddedMass, OfAPlungingPlateIsAQuarterOfPi) {
  EXPECT_NEAR(plate(MinamiMode::plunge, 0), pi / 4, quadrature);
}

// a = y = (1 + cos theta)/2 has the jump p = sin(theta)/2 + sin(2 theta)/8 by hand, so
// int y p dy = 9 pi/128, and int y^2 dy = 1/3.
TEST(AddedMass, OfAPitchingPlateIsThatOfItsSeries) {
  EXPECT_NEAR(plate(MinamiMode::pitch, 0), 27 * pi / 128, quadrature);
}

// At a free edge of a half plane p = (2/k) erf((k s)^1/2) a distance s from it (Wiener-Hopf), so
// each of the two edges takes 1/k^2 from 2/k; the edges do not feel each other but for exp(-k).
TEST(AddedMass, OfAPlungingPlateOfShortSpanIsThatOfTwoHalfPlanes) {
  for (const double k : {40.0, 100.0, 1000.0})
    EXPECT_NEAR(plate(MinamiMode::plunge, k), 2 / k - 2 / (k * k), quadrature / k) << k;
}

TEST(AddedMass, WithThePressureOfASheetIsLambs) {
  for (const MinamiMode mode : {MinamiMode::plunge, MinamiMode::hanging_chain})
    EXPECT_DOUBLE_EQ(minami({mode, MinamiPressure::sheet}, 3, 4), 2.0 / 5);
}

// The integral equation that the pressure must satisfy, by another route: a distribution p of
// doublets on the strip induces the acceleration
//   a(y) = -1/(2 pi) f.p. int p(eta) k K_1(k r)/r d eta,  r = |y - eta|.
// The kernel's 1/r^2 is done by hand (it turns sin(n theta) into n sin(n theta)/sin(theta)), the
// rest is integrable and left to GSL, with its singular point named.
TEST(AddedMass, OfAPlateComesFromAPressureThatSatisfiesTheIntegralEquation) {
  constexpr double k = 7.3;
  constexpr int terms = 64;
  const auto acceleration = [](double y) { return std::sin(2.5 * y) + 0.3; };
  const Eigen::VectorXd f = PlatePressure(k, terms).opposing(acceleration);
  const auto theta_of = [](double y) { return std::acos(2 * y - 1); };
  const auto p = [&](double y) {
    double sum = 0;
    for (int n = 1; n <= terms; ++n) sum += f[n - 1] * std::sin(n * theta_of(y));
    return sum;
  };
  gsl_set_error_handler_off();
  gsl_integration_workspace* workspace = gsl_integration_workspace_alloc(5000);
  for (const double y : {0.1, 0.37, 0.5, 0.9}) {
    std::function<double(double)> rest = [&](double eta) {
      const double r = std::abs(y - eta);
      if (r < 1e-9) return 0.0;
      return p(eta) * (k * gsl_sf_bessel_K1(k * r) / r - 1 / (r * r));
    };
    gsl_function function{
        [](double t, void* g) { return (*static_cast<std::function<double(double)>*>(g))(t); },
        &rest};
    std::array<double, 3> points = {0, y, 1};
    double integral = 0;
    double error = 0;
    gsl_integration_qagp(&function, points.data(), points.size(), 1e-9, 1e-9, 5000, workspace,
                         &integral, &error);
    double singular = 0;
    for (int n = 1; n <= terms; ++n)
      singular += n * f[n - 1] * std::sin(n * theta_of(y)) / std::sin(theta_of(y));
    EXPECT_NEAR(singular - integral / (2 * pi), acceleration(y), 1e-7) << y;
  }
  gsl_integration_workspace_free(workspace);
}

TEST(AddedMass, OfAnyFieldsFollowsTheIntegralB4) {
  // h = y cos(2 x) cos(3 t) at t = 0.2 with a pressure of 0.7 times minus its acceleration.
  const auto mode = [](double x, double y) { return y * std::cos(2 * x); };
  const FieldOnFlag h_t = [&](double x, double y) { return -3 * std::sin(0.6) * mode(x, y); };
  const FieldOnFlag h_tt = [&](double x, double y) { return -9 * std::cos(0.6) * mode(x, y); };
  const FieldOnFlag jump = [&](double x, double y) { return -0.7 * h_tt(x, y); };
  EXPECT_NEAR(minami(h_t, h_tt, jump, pi), 0.7, quadrature);
}

TEST(AddedMass, SaysSoWhereTheIntegralIsZeroOverZero) {
  // A travelling wave over whole wavelengths: its velocity and acceleration are out of phase.
  const FieldOnFlag h_t = [](double, double y) { return std::sin(2 * pi * y); };
  const FieldOnFlag h_tt = [](double, double y) { return std::cos(2 * pi * y); };
  EXPECT_THROW(minami(h_t, h_tt, h_tt, 1), SolverError);
}

TEST(AddedMass, OfAPlateSaysHowFarItGoes) {
  EXPECT_THROW(plate(MinamiMode::sine, 1e4), SolverError);
  EXPECT_THROW(plate(MinamiMode::sine, 1, 1e4), SolverError);
}

}  // namespace
}  // namespace pennon::lsa

/// Plates: the linear and the nonlinear deflection of a clamped plate, the frequency of a supported
/// one (appendix A of Banerjee, Connell & Yue 2015).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dns/flag/statics.hpp"
#include "dns/flag/stepper.hpp"
#include "tests/support/flags.hpp"
#include "tests/support/von_karman.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

Flag<3> square_plate(int N, Edge edge, const FlagMaterial& material) {
  return {FlagMesh(uniform_chord(N), N, 1.0, all_edges(edge)), material};
}

// Deflection of the centre under the load q per area.
double deflection(const Flag<3>& plate, double q) {
  NodeVectors<3> x = plate.rest();
  FlagLoads<3> loads;
  loads.node_forces = uniform_load(plate, 2, q);
  find_equilibrium(plate, loads, x);
  const int N = plate.mesh().chord_nodes();
  return x(2, plate.mesh().index(N / 2, N / 2));
}

TEST(ClampedPlate, BendsAsLinearTheorySaysAtSecondOrder) {
  // Timoshenko & Woinowsky-Krieger (1959), table 35, to the digits of later series: 0.00126532 q
  // L^4/D.
  constexpr double exact = 0.00126532;
  constexpr double q = 1e-4;  // so small that the stretch does not matter
  double previous = 0;
  int previous_N = 0;
  for (const int N : {11, 15, 21, 25, 31}) {
    const double error =
        deflection(square_plate(N, Edge::clamped, {1, 1, 1e4, 0.3, 0}), q) / q - exact;
    if (previous_N > 0) {
      EXPECT_GE(order(previous, error, (N - 1.0) / (previous_N - 1.0)), 1.9) << N;
    }
    previous = error;
    previous_N = N;
  }
  EXPECT_LT(previous / exact, 0.01);
}

// Both are second order: the limit of fine grids.
double extrapolated_deflection(const FlagMaterial& material, double q) {
  const double coarse = deflection(square_plate(17, Edge::clamped, material), q);
  const double fine = deflection(square_plate(33, Edge::clamped, material), q);
  return fine + (fine - coarse) / 3;
}

FlagMaterial plate_of_thickness(double h, double nu_s) {
  return {1, 1, 12 / (h * h), nu_s, 0};
}

// Levy (1942, NACA TN 847) gives w/h = 0.237 at q L^4/(E h^4) = 17.79 and Poisson ratio 0.1^1/2
// from a double Fourier series. The Ritz solution of the same equations, converged to six digits,
// is 0.236134: the series was cut 0.4 % high, and that is what the flag differs by.
TEST(ClampedPlate, StiffensAsVonKarmanTheorySays) {
  const double nu_s = std::sqrt(0.1);
  constexpr double h = 0.005;  // thin, so that slopes are small as the theory assumes
  const FlagMaterial material = plate_of_thickness(h, nu_s);
  const double E = material.K_S * (1 - nu_s * nu_s) / h;
  for (const double load : {17.79, 184.0}) {
    const double q = load * E * std::pow(h, 4);
    const double theory = RitzPlate(5, 1, material.K_S, nu_s).deflection(q);
    EXPECT_NEAR(extrapolated_deflection(material, q) / theory, 1, 1e-3) << load;
    if (load == 17.79) {
      EXPECT_NEAR(theory / h, 0.237, 0.001) << "Levy's third digit, off by one";
    }
  }
}

// The paper's load, L/h = 20: it prints 0.02615 with the same digits as the load. The theory has
// 0.02828 L, 15 % below the linear 0.0331 L; a plate of that thickness departs from it with the
// square of its slope.
TEST(ClampedPlate, UnderThePapersLoadHasFourteenPercentLessThanLinear) {
  constexpr double q = 26.15;
  const auto departure = [&](double h) {
    // The same w/h: the load scales with the thickness.
    const double scaled = q * h / 0.05;
    const FlagMaterial material = plate_of_thickness(h, 0.3);
    return extrapolated_deflection(material, scaled) /
               RitzPlate(5, 1, material.K_S, 0.3).deflection(scaled) -
           1;
  };
  EXPECT_NEAR(departure(0.05), 0, 0.005);
  EXPECT_LT(std::abs(departure(0.0125)), 0.4 * std::abs(departure(0.05)));
  EXPECT_NEAR(RitzPlate(5, 1, 4800, 0.3).deflection(q) / (0.00126532 * q), 0.855, 0.001);
}

// Frequency of the first mode from the phase of a small free vibration.
double measured_frequency(const Flag<3>& plate, TimeScheme scheme, double dt, double exact) {
  FlagStepper<3> stepper(plate, scheme, {.tolerance = 1e-14, .contraction = 0.5});
  const FlagMesh& mesh = plate.mesh();
  NodeVectors<3> x = plate.rest();
  Eigen::VectorXd shape(mesh.nodes());
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      shape[mesh.index(i, j)] = std::sin(pi * mesh.x(i)) * std::sin(pi * mesh.y(j));
  x.row(2) = 1e-7 * shape.transpose();
  FlagState<3> state = stepper.start(x);
  // Down from the top through zero: a quarter period, by the sine of the phase at the last step
  // before.
  const double quarter = pi / (2 * exact);
  const auto amplitude = [&] { return state.x.row(2).dot(shape) / (1e-7 * shape.squaredNorm()); };
  while (state.t + 1.5 * dt < quarter)
    stepper.advance(
        state, [](double) { return FlagLoads<3>{}; }, dt);
  return std::acos(std::min(1.0, amplitude())) / state.t;
}

TEST(SupportedPlate, VibratesAsLinearTheorySaysAtSecondOrderInTime) {
  const Flag<3> plate = square_plate(25, Edge::pinned, {1, 1, 1e4, 0.3, 0});
  const double exact = 2 * pi * pi;
  const double discrete = linear_modes(plate, plate.rest(), {}).omega[0];
  EXPECT_NEAR(discrete / exact, 1, 0.003) << "the grid's own error, second order";
  double previous = 0;
  for (const double dt : {0.01, 0.005, 0.0025}) {
    const double error =
        measured_frequency(plate, TimeScheme::energy_conserving, dt, exact) - discrete;
    if (previous != 0) {
      EXPECT_GE(order(previous, error, 2), 1.95) << dt;
    }
    previous = error;
  }
}

}  // namespace
}  // namespace pennon::dns

/// Flags in two dimensions: the elastica, the hanging chain, the modes in vacuum.
#include <gsl/gsl_sf_bessel.h>
#include <gsl/gsl_sf_ellint.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "dns/flag/statics.hpp"
#include "dns/flag/stepper.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

// The cantilever whose tip has the angle `tip` under a transverse load that keeps its direction
// (Bisshopp & Drucker 1945): load P L^2/EI and tip position by elliptic integrals.
struct Elastica {
  double load, x, z;

  explicit Elastica(double tip) {
    const double k = std::sqrt((1 + std::sin(tip)) / 2);
    const double phi = std::asin(1 / (k * std::numbers::sqrt2));
    const double beta =
        gsl_sf_ellint_Kcomp(k, GSL_PREC_DOUBLE) - gsl_sf_ellint_F(phi, k, GSL_PREC_DOUBLE);
    load = beta * beta;
    x = std::sqrt(2 * std::sin(tip)) / beta;
    z = 1 -
        2 / beta *
            (gsl_sf_ellint_Ecomp(k, GSL_PREC_DOUBLE) - gsl_sf_ellint_E(phi, k, GSL_PREC_DOUBLE));
  }
};

TEST(Elastica, BendsToTheExactShapeAtSecondOrder) {
  for (const double tip : {0.3, 0.9, 1.3}) {
    const Elastica exact(tip);
    double previous = 0;
    for (const int N : {26, 51, 101}) {
      const Flag<2> flag(FlagMesh(uniform_chord(N), {Edge::clamped, Edge::free}),
                         {1, 1, 1e7, 0.3, 0});
      NodeVectors<2> x = flag.rest();
      FlagLoads<2> loads;
      loads.node_forces = NodeVectors<2>::Zero(2, N);
      loads.node_forces(1, N - 1) = exact.load;
      find_equilibrium(flag, loads, x);
      const double error = std::hypot(x(0, N - 1) - exact.x, x(1, N - 1) - exact.z);
      if (previous > 0) {
        EXPECT_GE(order(previous, error, 2), 1.9) << tip << " " << N;
      }
      previous = error;
    }
    EXPECT_LT(previous, 1e-3) << "0.1 % of the chord";
  }
}

// A chain that hangs along y under gravity, its nodes denser toward the free end, where waves are
// short.
Flag<2> chain(int N) {
  std::vector<double> y = uniform_chord(N);
  for (double& value : y) value = std::sin(pi / 2 * value);
  return {FlagMesh(y, {Edge::pinned, Edge::free}), {1, 0, 1e5, 0.3, 0}};
}

FlagLoads<2> weight(double g = 1) {
  FlagLoads<2> loads;
  loads.gravity = {g, 0};
  return loads;
}

NodeVectors<2> hanging(const Flag<2>& flag, const FlagLoads<2>& loads) {
  NodeVectors<2> x = flag.rest();
  x.row(0) *= 1.0001;  // some tension, to be regular across
  find_equilibrium(flag, loads, x);
  return x;
}

TEST(HangingChain, SwingsWithTheZerosOfTheBesselFunction) {
  const Flag<2> flag = chain(101);
  const Eigen::VectorXd omega = transverse_modes(flag, hanging(flag, weight()), weight()).omega;
  for (unsigned n = 1; n <= 4; ++n)
    EXPECT_NEAR(omega[static_cast<int>(n) - 1] / (gsl_sf_bessel_zero_J0(n) / 2), 1, 1e-3) << n;
}

// Released straight at a small angle, the chain is a sum of its modes; what remains is of the third
// power of the angle, and at 0.1 pi within 5 % of it.
double departure_from_modes(double angle) {
  const int N = 101;
  const Flag<2> flag = chain(N);
  FlagStepper<2> stepper(flag, TimeScheme::energy_conserving);
  NodeVectors<2> x = hanging(flag, weight());
  for (int j = 0; j < N; ++j)
    x.col(j) = x(0, j) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  FlagState<2> state = stepper.start(x);
  double worst = 0;
  for (int step = 1; step <= 800; ++step) {
    stepper.advance(
        state, [](double) { return weight(); }, 0.0025);
    double tip =
        0;  // angle y = sum c_n J_0(alpha_n (1-y)^1/2), c_n = 8 angle/(alpha_n^3 J_1(alpha_n))
    for (unsigned n = 1; n <= 60; ++n) {
      const double alpha = gsl_sf_bessel_zero_J0(n);
      tip += 8 * angle / (alpha * alpha * alpha * gsl_sf_bessel_J1(alpha)) *
             std::cos(alpha / 2 * state.t);
    }
    worst = std::max(worst, std::abs(state.x(1, N - 1) - tip));
  }
  return worst / angle;
}

TEST(HangingChain, ReleasedStraightIsTheSumOfItsModesAtSmallAngles) {
  EXPECT_LT(departure_from_modes(0.001 * pi), 0.01) << "grid and step";
  EXPECT_LT(departure_from_modes(0.1 * pi), 0.06) << "and the geometry";
}

}  // namespace
}  // namespace pennon::dns

// The linear growth of the simulation is the global eigenvalue: the simulation starts in the steady
// flow with a little of a global mode added, and goes on as that mode.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "dns/mode_start.hpp"
#include "tests/support/global_mode.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double amplitude = 1e-6;

// lambda of z = Re(a exp(lambda t)), from z every h: Prony's recursion z_{n+1} = 2 r cos z_n - r^2
// z_{n-1}, in least squares.
Complex exponent_of(const std::vector<double>& z, double h, std::size_t apart) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (std::size_t n = apart; n + apart < z.size(); ++n) {
    const double a = z[n], b = z[n - apart], c = z[n + apart];
    aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
  }
  const double determinant = aa * bb - ab * ab;
  const double p = (ac * bb - bc * ab) / determinant, q = (bc * aa - ac * ab) / determinant;
  const Complex root = p / 2 + std::sqrt(Complex(p * p / 4 + q));
  return std::log(root) / (h * static_cast<double>(apart));
}

// The simulation's lambda with steps of dt over a time.
template <int dim>
Complex simulated(const test::CoupledCase& settings, const dns::FlowMode& mode, double dt,
                  double duration) {
  dns::Fluid fluid(dns::OGrid(settings.grid), dns::Span(settings.planes, settings.span),
                   settings.fluid, settings.tolerances);
  const dns::Flag<dim> flag(test::coupled_mesh(settings, fluid.grid()), settings.flag);
  dns::Coupling<dim> coupling(fluid, flag, Eigen::Matrix<double, dim, 1>::Zero(),
                              settings.coupling);
  dns::CoupledState<dim> state = start_in_mode(coupling, fluid, flag, mode, amplitude, dt);
  std::vector<double> z;
  const auto steps = std::lround(duration / dt);
  for (long n = 0; n < steps; ++n) {
    coupling.advance(state, dt);
    z.push_back(state.flag.x(dim - 1, flag.mesh().chord_nodes() - 1));
  }
  const double eighth = std::numbers::pi / (4 * std::abs(mode.lambda.imag()));
  return exponent_of(z, dt, static_cast<std::size_t>(std::lround(eighth / dt)));
}

// The error of the simulation's lambda with a step.
template <int dim>
double error_with(double dt, const test::CoupledCase& settings, Complex target) {
  const double k_x = dim == 2 ? 0 : 2 * std::numbers::pi / settings.span;
  const dns::FlowMode mode = test::mode_near(settings, k_x, dt, target);
  constexpr double duration = 1.2;
  return std::abs(simulated<dim>(settings, mode, dt, duration) - mode.lambda) /
         std::abs(mode.lambda);
}

// Of second order: a fourth and a little to spare.
constexpr double share_at_half_the_step = 0.31;

// With steps of 0.02 and 0.01.
template <int dim>
void expect_second_order(const test::CoupledCase& settings, Complex target, double bound) {
  const double coarse = error_with<dim>(0.02, settings, target);
  const double fine = error_with<dim>(0.01, settings, target);
  EXPECT_LT(coarse, bound);
  EXPECT_LT(fine, share_at_half_the_step * coarse);
}

test::CoupledCase wide_case() {
  test::CoupledCase wide = test::small_case();
  wide.planes = 8;
  wide.span = 2;
  return wide;
}

TEST(GlobalGrowth, OfTheSimulationInTwoDimensionsIsTheEigenvalueUpToTheSquareOfTheStep) {
  expect_second_order<2>(test::small_case(), {0.44, 2.66}, 1e-3);
}

TEST(GlobalGrowth, OfAWaveAlongTheSpanIsTheEigenvalueUpToTheSquareOfTheStep) {
  expect_second_order<3>(wide_case(), {-0.1, 2.8}, 2e-3);
}

// The shear that the cross-flow leaves in the flag is worth 5 % of lambda here.
TEST(GlobalGrowth, OfAWaveInACrossFlowIsTheEigenvalueUpToTheSquareOfTheStep) {
  test::CoupledCase settings = wide_case();
  settings.fluid.U = 0.5;
  expect_second_order<3>(settings, {-0.476, 2.66}, 5e-3);
}

}  // namespace
}  // namespace pennon::modes::global

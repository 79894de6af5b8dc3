// The linear growth of the simulation is the global eigenvalue: the simulation starts in the steady
// flow with a little of a global mode added, and goes on as that mode.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/global_growth.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// The error of the simulation's lambda with a step.
template <int dim>
double error_with(double dt, const test::CoupledCase& settings, Complex target) {
  const double k_x = dim == 2 ? 0 : 2 * std::numbers::pi / settings.span;
  const dns::FlowMode mode = test::mode_near(settings, k_x, dt, target);
  constexpr double duration = 1.2;
  return std::abs(test::simulated<dim>(settings, mode, dt, duration) - mode.lambda) /
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

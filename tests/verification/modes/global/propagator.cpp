// The leading global mode without a matrix: eigenvalues exp(lambda T) of what the simulation itself
// makes of a small disturbance in a time T, by ARPACK, against the shifted and inverted operator.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "dns/coupling/mode_start.hpp"
#include "modes/global/matrix_free/map_eigenpairs.hpp"
#include "modes/global/matrix_free/propagator.hpp"
#include "tests/support/global_mode.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

template <int dim>
Complex of_the_simulation(const test::CoupledCase& settings, const dns::FlowMode& steady, double dt,
                          long steps) {
  dns::Fluid fluid(dns::OGrid(settings.grid), dns::Span(settings.planes, settings.span),
                   settings.fluid, settings.tolerances);
  const dns::Flag<dim> flag(test::coupled_mesh(settings, fluid.grid()), settings.flag);
  dns::Coupling<dim> coupling(fluid, flag, Eigen::Matrix<double, dim, 1>::Zero(),
                              settings.coupling);
  // The steady flow alone is the fixed point; two steps find the pressure jump on it.
  dns::CoupledState<dim> base = start_in_mode(coupling, fluid, flag, steady, 0, dt);
  for (int n = 0; n < 2; ++n) coupling.advance(base, dt);
  dns::Propagator<dim> propagator(coupling, base,
                                  {.dt = dt, .steps = static_cast<int>(steps), .amplitude = 1e-4});
  const LinearMap map = [&](const double* in, double* out) { propagator.apply(in, out); };
  Eigen::VectorXd start(propagator.size());
  map(propagator.thrown_flag().data(), start.data());
  const std::vector<MapEigenpair> found =
      largest_eigenpairs(map, start, {.count = 2, .basis = 12, .tolerance = 1e-6});
  EXPECT_LT(found.front().residual, 1e-4);
  return std::log(found.front().value) / propagator.time();
}

// With steps of dt and half of it.
template <int dim>
void expect_second_order(const test::CoupledCase& settings, Complex target, double dt,
                         double bound) {
  constexpr double time = 0.4;
  const auto error = [&](double step) {
    const double k_x = dim == 2 ? 0 : 2 * std::numbers::pi / settings.span;
    const dns::FlowMode mode = test::mode_near(settings, k_x, step, target);
    return std::abs(of_the_simulation<dim>(settings, mode, step, std::lround(time / step)) -
                    mode.lambda) /
           std::abs(mode.lambda);
  };
  const double coarse = error(dt), fine = error(dt / 2);
  EXPECT_LT(coarse, bound);
  EXPECT_LT(fine, 0.31 * coarse);
}

TEST(GlobalPropagator, HasTheLeadingEigenvalueUpToTheSquareOfTheStep) {
  expect_second_order<2>(test::small_case(), {0.44, 2.66}, 0.02, 2.5e-3);
}

TEST(GlobalPropagator, HasThatOfAWaveAlongTheSpan) {
  test::CoupledCase settings = test::small_case();
  settings.planes = 4;
  settings.span = 2;
  expect_second_order<3>(settings, {-0.1, 2.8}, 0.04, 1.5e-2);
}

}  // namespace
}  // namespace pennon::modes::global

// The fluid along its span: what the Fourier series there must do within a step.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

// Smooth in the plane, zero at the flag and far from it.
double bump(double y, double z) {
  const double r = std::hypot(y - 0.5, z) - 1.3;
  return std::exp(-60 * r * r);
}

// Adds amplitude cos(2 pi n x/S) bump to the velocity along y and z.
void add_wave(FluidRun& run, int n, double amplitude) {
  run.at_cells([&](int plane, int j, int i) {
    const auto [y, z] = run.fluid().centre(run.state(), plane, j, i);
    const double wave =
        amplitude * bump(y, z) * std::cos(2 * pi * n * plane / run.fluid().extent().planes + n);
    run.state().u[0].row(plane, j)[i] += wave;
    run.state().u[1].row(plane, j)[i] -= 0.5 * wave;
  });
  run.state().u_last = run.state().u;
}

// The largest part of each Fourier component of a field along the span.
std::vector<double> components_of(const Field<double>& f) {
  const Extent& extent = f.extent();
  std::vector<double> largest(static_cast<std::size_t>(extent.planes / 2 + 1), 0.0);
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i)
      for (std::size_t n = 0; n < largest.size(); ++n) {
        std::complex<double> sum = 0;
        for (int plane = 0; plane < extent.planes; ++plane)
          sum += f.row(plane, j)[i] *
                 std::polar(1.0 / extent.planes,
                            -2 * pi * static_cast<double>(n) * plane / extent.planes);
        largest[n] = std::max(largest[n], std::abs(sum));
      }
  return largest;
}

FluidCase with_planes(int planes, double Re) {
  FluidCase settings;
  settings.grid = {16, 32, 3, 0.05, 0};
  settings.parameters = {Re, 0.3};
  settings.planes = planes;
  settings.span = 1;
  settings.tolerances = {1e-11, 1e-12, 1e-8, 20};
  return settings;
}

// Waves 3 and 4 of 12 planes make 6, 7, which looks like 5, and 8: none of them is kept. A step
// leaves nothing there but what the implicit part makes of the change in the step, of second order
// in its length; a product that is not cut would be of first order.
TEST(FluidAlongTheSpan, HasNothingOfWavesAboveTheCutButAtSecondOrder) {
  constexpr int planes = 12;
  const auto left = [&](double dt) {
    FluidRun run(with_planes(planes, 200));
    run.run_to(0.05, 0.01);
    add_wave(run, 3, 0.3);
    add_wave(run, 4, 0.2);
    run.step(dt);
    std::vector<double> largest;
    for (const Field<double>& u : run.state().u) largest.push_back(components_of(u)[5]);
    EXPECT_GT(components_of(run.state().u[0])[1], 0.01 * dt) << "their difference is felt";
    return *std::ranges::max_element(largest);
  };
  constexpr double dt = 0.001;
  EXPECT_GT(left(dt) / left(dt / 4), 12) << "4 at first order, 16 at second";
}

// Friction along the span with steps 400 times as long as an explicit term would bear.
TEST(FluidAlongTheSpan, IsCalmedByFrictionHoweverManyPlanesThereAre) {
  constexpr int planes = 48;
  constexpr double dt = 0.02;
  FluidCase settings = with_planes(planes, 20);
  settings.tolerances = {1e-7, 1e-7, 1e-8, 20};
  FluidRun run(settings);
  run.run_to(0.1, dt);
  const double without = run.budget().kinetic_energy;
  for (const int n : {1, 5, 11, 15}) add_wave(run, n, 0.2);
  const double disturbed = run.budget().kinetic_energy - without;
  ASSERT_GT(disturbed, 1e-3);
  run.run_to(0.5, dt);
  for (std::size_t c = 0; c < run.state().u.size(); ++c) {
    const std::vector<double> left = components_of(run.state().u[c]);
    for (std::size_t n = 1; n < left.size(); ++n)
      EXPECT_LT(left[n], n < 5 ? 0.1 : 0.005) << c << " " << n;
  }
}

}  // namespace
}  // namespace pennon::dns

// A vortex leaves through the outer boundary.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

constexpr double y_start = 3, Re = 200;

// Grids of the same inner cells: a constant spacing of rho.
constexpr double spacing = 0.053;
constexpr int near_rows = 60, far_rows = 73;  // R = 6 and 12

FluidCase wide_case(int rows) {
  FluidCase settings;
  settings.grid = {rows, 96, std::sinh(spacing * rows) / 2, spacing, 0.5};
  settings.parameters = {Re, 0};
  return settings;
}

// Taylor's vortex, without circulation: the velocity has its peak, `strength`, at the radius 0.8.
void add_vortex(FluidRun& run, double strength) {
  constexpr double radius = 0.8;
  run.at_cells([&](int plane, int j, int i) {
    const auto [y, z] = run.fluid().centre(run.state(), plane, j, i);
    const double square = ((y - y_start) * (y - y_start) + z * z) / (radius * radius);
    const double spin = strength / radius * std::exp((1 - square) / 2);
    run.state().u[0].row(plane, j)[i] -= spin * z;
    run.state().u[1].row(plane, j)[i] += spin * (y - y_start);
  });
  run.state().u_last = run.state().u;
}

// A plate's wake with a vortex, and the same without.
struct Pair {
  FluidRun with, without;

  Pair(int rows, double strength) : with(wide_case(rows)), without(wide_case(rows)) {
    run_to(0.2);
    add_vortex(with, strength);
  }
  void run_to(double t) {
    with.run_to(t, 0.04);
    without.run_to(t, 0.04);
  }
  double difference(std::size_t c, int j, int i) {
    return with.state().u[c].row(0, j)[i] - without.state().u[c].row(0, j)[i];
  }
};

// Kinetic energy, within R = 6, of what the vortex makes different in one pair, less what it makes
// different in another one if that is given.
double energy(Pair& pair, Pair* other = nullptr) {
  double sum = 0;
  for (int j = 0; j < near_rows; ++j)
    for (int i = 0; i < pair.with.grid().n_theta(); ++i)
      for (std::size_t c = 0; c < 2; ++c) {
        const double u = pair.difference(c, j, i) - (other ? other->difference(c, j, i) : 0.0);
        sum += pair.with.fluid().metrics().volume.row(0, j)[i] / 2 * u * u;
      }
  return sum;
}

// A vortex with a fifth of the stream's velocity leaves as it does where the boundary is twice as
// far: what differs is a share of 0.003 of its energy while it crosses, and a tenth of that when it
// has gone.
TEST(Outflow, LetsAVortexLeave) {
  Pair near(near_rows, 0.2), far(far_rows, 0.2);
  const double first = energy(near);
  double previous = first;
  for (int n = 1; n <= 17; ++n) {
    const double t = 0.2 + 0.4 * n;
    near.run_to(t);
    far.run_to(t);
    const double now = energy(near), reflected = energy(near, &far);
    EXPECT_LT(now, previous + 1e-4 * first) << "energy piles up at t = " << t;
    EXPECT_LT(reflected, (t < 6.9 ? 0.005 : 0.001) * first) << t;
    previous = now;
  }
  EXPECT_LT(previous, 0.001 * first);
}

// A vortex that turns the flow back at the boundary, where no value is known for what enters, is
// held up there for a while and reflects a fifth of its energy, but it never gains any and goes.
TEST(Outflow, StaysStableWhereAVortexTurnsItBack) {
  Pair pair(near_rows, 1.5);
  const double first = energy(pair);
  double previous = first;
  int turned = 0;
  for (int n = 1; n <= 24; ++n) {
    const double t = 0.2 + 0.4 * n;
    pair.run_to(t);
    for (int i = 0; i < pair.with.grid().n_theta(); ++i)
      turned += pair.with.state().is_inflow[static_cast<std::size_t>(i)] &&
                std::cos(pair.with.grid().theta_centre(i)) > 0.5;
    const double now = energy(pair);
    EXPECT_LT(now, previous) << "energy piles up at t = " << t;
    previous = now;
  }
  EXPECT_GT(turned, 0) << "the vortex was too weak for this test";
  EXPECT_LT(previous, 0.02 * first);
}

}  // namespace
}  // namespace pennon::dns

// The flag and the flow together, against what they must give together.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "tests/support/coupled.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

double small_bend(double, double y) {
  return 0.02 * y * y * (1.5 - y);
}

// Of a beam clamped at its leading edge in a fluid at rest (flat, frictionless): M and K of the
// flag along z, with the added mass.
double frequency_with_added_mass(const Flag<2>& flag, const OGrid& grid) {
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  const NodeVectors<2> rest = flag.rest();
  flag.add_tangent({rest, rest}, {}, 0, *tangent);
  const Eigen::MatrixXd stiffness = tangent->matrix();
  const auto free = tangent->free_nodes();
  const auto n = static_cast<Eigen::Index>(free.size());
  Eigen::MatrixXd K(n, n), M = Eigen::MatrixXd::Zero(n, n);
  const FlagMesh& mesh = flag.mesh();
  const int segments = mesh.chord_nodes() - 1;
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(segments, segments + 1);
  for (int s = 0; s < segments; ++s) E(s, s) = E(s, s + 1) = mesh.dy(s) / 2;
  const Eigen::MatrixXd added = E.transpose() * flat_jump_response(grid, 0) * E;
  for (Eigen::Index a = 0; a < n; ++a)
    for (Eigen::Index b = 0; b < n; ++b) {
      const int node_a = free[static_cast<std::size_t>(a)],
                node_b = free[static_cast<std::size_t>(b)];
      K(a, b) = stiffness(2 * a + 1, 2 * b + 1);
      M(a, b) = (added(node_a, node_b) + added(node_b, node_a)) / 2 +
                (a == b ? flag.mass()[node_a] : 0.0);
    }
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(K, M);
  return std::sqrt(modes.eigenvalues()[0]);
}

// So stiff that the stream has no time to act: what slows the beam is the fluid's inertia.
TEST(Coupling, OfAStiffBeamVibratesWithItsAddedMass) {
  CoupledCase settings;
  settings.fluid.Re = 1e5;
  settings.flag = {.mu = 0.3, .K_B = 5000, .K_S = 1e6};
  settings.leading_edge = Edge::clamped;
  CoupledRun<2> run(settings,
                    [](double, double y) { return 1e-3 * y * y * (6 - 4 * y + y * y) / 3; });
  const double omega = frequency_with_added_mass(run.flag(), run.fluid().grid());
  const double alone = 3.516 * std::sqrt(settings.flag.K_B / settings.flag.mu);
  EXPECT_LT(omega, 0.75 * alone);  // the fluid is as heavy as the beam
  constexpr int steps_of_period = 100, periods = 5;
  const double dt = 2 * pi / omega / steps_of_period;
  std::vector<double> crossings;
  double last = run.trailing_edge();
  for (int n = 1; n <= periods * steps_of_period; ++n) {
    run.step(dt);
    const double now = run.trailing_edge();
    if (last < 0 && now >= 0) crossings.push_back((n - now / (now - last)) * dt);
    last = now;
  }
  ASSERT_GE(crossings.size(), 4U);
  const double measured =
      2 * pi * static_cast<double>(crossings.size() - 1) / (crossings.back() - crossings.front());
  // Backward differences slow a vibration by (omega dt)^2/3.
  const double expected = omega * (1 - std::pow(omega * dt, 2) / 3);
  EXPECT_NEAR(measured / expected, 1, 0.005);
}

// The work that the fluid says it does is what the flag's energies say it gets.
TEST(Coupling, PassesOnTheWorkOfTheFluid) {
  std::array<double, 2> defect{}, mismatch{};
  for (std::size_t k = 0; k < 2; ++k) {
    CoupledRun<2> run({}, small_bend);
    const double dt = 0.004 / static_cast<double>(1 << k);
    const double begin = 0.1, end = 0.5;
    run.run_to(begin, dt);
    const auto energy = [&] {
      return run.flag().energies(run.state().flag.x, run.state().flag.v, {}).total() +
             run.state().flag.dissipated;
    };
    // Power of the wall on the fluid, in the frame of the flag.
    const auto wall_power = [&] {
      const WallTraction traction = wall_traction(run.fluid(), run.state().fluid);
      double power = 0;
      for (std::size_t axis = 1; axis < 3; ++axis)
        for (std::size_t face = 0; face < traction.pressure.size(); ++face)
          power += traction.force[axis][face] * run.fluid().wall_velocity()[axis - 1][face];
      return power;
    };
    const double energy_before = energy(), work_before = run.state().flag.work;
    double work_of_wall = 0, last = wall_power();
    while (run.state().fluid.t < end - dt / 2) {
      run.step(dt);
      const double now = wall_power();
      work_of_wall += dt * (last + now) / 2;
      last = now;
    }
    const double work = run.state().flag.work - work_before;
    defect[k] = std::abs(energy() - energy_before - work);
    mismatch[k] = std::abs(work - work_of_wall) / std::abs(work);
  }
  EXPECT_GT(defect[0] / defect[1], 3);
  EXPECT_LT(mismatch[1], 1e-3);
}

// A straight flag in the developed stream, kicked smoothly. Of first order, though each part is of
// second: the smoothing of the pressure by dt' (docs/theory/fluid.md) acts on the flow about the
// edges, and it is as dt.
TEST(Coupling, ConvergesInTime) {
  std::array<double, 4> z{};
  for (std::size_t k = 0; k < z.size(); ++k) {
    CoupledCase settings;
    settings.coupling.tolerance = 1e-8;
    CoupledRun<2> run(settings, [](double, double) { return 0.0; });
    const double dt = 0.04 / std::pow(2, k);
    constexpr double kick_at = 2, duration = 0.5;
    run.start_steps(dt);
    run.run_to(kick_at, dt);
    const FlagMesh& mesh = run.flag().mesh();
    for (auto n = std::lround(1 / dt); n > 0; --n) {
      NodeVectors<2> force = NodeVectors<2>::Zero(2, mesh.nodes());
      const double since = run.state().fluid.t + dt - kick_at;
      if (since < duration)
        for (int j = 0; j < mesh.chord_nodes(); ++j)
          force(1, j) =
              0.1 * std::pow(std::sin(pi * since / duration), 4) * mesh.y(j) * mesh.chord_share(j);
      run.coupling().set_outer_force(force);
      run.step(dt);
    }
    z[k] = run.trailing_edge();
  }
  constexpr double amplitude = 0.0135;
  for (std::size_t k = 0; k + 2 < z.size(); ++k)
    EXPECT_GT((z[k] - z[k + 1]) / (z[k + 1] - z[k + 2]), 1.8);
  EXPECT_LT(std::abs(z[2] - z[3]), 0.01 * amplitude);
}

// Light flags, whose added mass is up to hundreds of times their own, take no more passes.
TEST(Coupling, TakesFewPassesHoweverLightTheFlag) {
  for (const double mu : {0.001, 0.025, 0.125, 1.0, 10.0}) {
    CoupledCase settings;
    settings.flag.mu = mu;
    settings.coupling.tolerance = 1e-5;
    settings.tolerances = {};
    CoupledRun<2> run(settings, [](double, double y) { return 0.1 * y * y * (1.5 - y); });
    run.run_to(0.01, 5e-4);
    int passes = 0, steps = 0;
    while (run.state().fluid.t < 1) {
      passes += run.step(0.004).passes;
      ++steps;
    }
    EXPECT_LE(passes, 3 * steps) << "mu = " << mu;
    EXPECT_TRUE(std::isfinite(run.trailing_edge()));
  }
}

// The same flag, its span given as three-dimensional, moves as in two dimensions.
TEST(Coupling, WithoutAWaveAlongTheSpanIsTheTwoDimensionalOne) {
  CoupledCase settings;
  settings.grid = {.n_rho = 20, .n_theta = 40, .R = 6, .wall_spacing = 0.04};
  settings.flag.nu_s = 0;  // else the span's tension stretches the chord
  CoupledRun<2> flat(settings, small_bend);
  settings.planes = 4;
  settings.span = 1.5;
  CoupledRun<3> wide(settings, small_bend);
  flat.run_to(0.2, 0.005);
  wide.run_to(0.2, 0.005);
  for (int m = 0; m < settings.planes; ++m)
    EXPECT_NEAR(wide.trailing_edge(m), flat.trailing_edge(), 1e-7);
  EXPECT_GT(std::abs(flat.trailing_edge() - small_bend(0, 1)), 1e-4);
}

// One wave along the span, its phase moved by a quarter: the same motion a quarter further.
TEST(Coupling, DoesNotPreferAPlaceAlongTheSpan) {
  CoupledCase settings;
  settings.grid = {.n_rho = 20, .n_theta = 40, .R = 6, .wall_spacing = 0.04};
  settings.planes = 8;
  settings.span = 2;
  const auto wave = [](double phase) {
    return [phase](double x, double y) { return std::cos(pi * x + phase) * small_bend(0, y); };
  };
  CoupledRun<3> one(settings, wave(0)), other(settings, wave(pi / 2));
  one.run_to(0.1, 0.005);
  other.run_to(0.1, 0.005);
  for (int m = 0; m < 8; ++m)
    EXPECT_NEAR(other.trailing_edge(m), one.trailing_edge((m + 2) % 8), 1e-7);
}

TEST(Coupling, KeepsTheWallOfTheGridAtTheFlag) {
  CoupledRun<2> run({}, [](double, double y) { return 0.1 * y * y * (1.5 - y); });
  run.run_to(0.01, 5e-4);
  double farthest = 0;
  while (run.state().fluid.t < 1.5) {
    run.step(0.004);
    const FluidState& fluid = run.state().fluid;
    farthest = std::max(farthest, std::abs(fluid.grid[0].z.row(0, 0)[0] - run.trailing_edge()));
  }
  EXPECT_LT(farthest, 2e-4);
}

}  // namespace
}  // namespace pennon::dns

/// Flags at the ends of what a case may ask: each is solved, or stops with a sentence.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "dns/flag/statics.hpp"
#include "dns/flag/stepper.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

const EdgeConditions cantilever{Edge::clamped, Edge::free};
const EdgeConditions pendulum{Edge::pinned, Edge::free};

// Factorisations that the search of an equilibrium may take: where Newton's method goes straight to
// it, and where it passes a bifurcation. They do not grow with the stiffness of the stretch.
constexpr int few = 10;
constexpr int several = 100;

FlagLoads<2> weight(double y, double z) {
  FlagLoads<2> loads;
  loads.gravity = {y, z};
  return loads;
}

// Energy drift of a pendulum swung from the horizontal for half a time unit, and the Newton
// iterations.
struct Swing {
  double drift;
  int most_iterations;
};
Swing swing(const FlagMaterial& material, double dt, int N = 41) {
  const Flag<2> flag(FlagMesh(uniform_chord(N), pendulum), material);
  FlagStepper<2> stepper(flag, TimeScheme::energy_conserving);
  FlagState<2> state = stepper.start();
  FlagLoads<2> loads = weight(0, -1);
  Swing result{};
  while (state.t < 0.5) {
    const StepSummary step = stepper.advance(
        state, [&](double) { return loads; }, dt);
    result.most_iterations = std::max(result.most_iterations, step.iterations / step.parts);
    const double total = flag.energies(state.x, state.v, loads).total();
    result.drift = std::max(result.drift, std::abs(total + state.dissipated));
  }
  return result;
}

TEST(FlagAtTheExtremes, SwingsWithoutBendingAndWithAlmostNone) {
  for (const double K_B : {0.0, 1e-12})
    EXPECT_LT(swing({1, K_B, 500, 0.3, 0}, 0.005).drift, 1e-7) << K_B;
}

TEST(FlagAtTheExtremes, NeitherLocksNorNeedsMoreIterationsAsTheStretchStiffens) {
  double position = 0;
  for (const double K_S : {1e4, 1e6, 1e8}) {
    const Swing result = swing({1, 1e-4, K_S, 0.3, 0}, 0.002);
    EXPECT_LE(result.most_iterations, 10) << K_S;
    const Flag<2> flag(FlagMesh(uniform_chord(41), cantilever), {1, 1, K_S, 0.3, 0});
    NodeVectors<2> x = flag.rest();
    FlagLoads<2> loads;
    loads.node_forces = NodeVectors<2>::Zero(2, 41);
    loads.node_forces(1, 40) = 2;
    EXPECT_LE(find_equilibrium(flag, loads, x).iterations, few) << K_S;
    if (position > 0) {
      EXPECT_NEAR(x(1, 40), position, 1e-3) << K_S;
    }
    position = x(1, 40);
  }
}

TEST(FlagAtTheExtremes, IsHardlyThereAtAMassOfOneMillionth) {
  // Without inertia it hangs down at once, as far as its damping lets it.
  const Flag<2> flag(FlagMesh(uniform_chord(21), cantilever), {1e-6, 1, 500, 0.3, 0.01});
  FlagStepper<2> stepper(flag, TimeScheme::backward_difference);
  FlagState<2> state = stepper.start();
  FlagLoads<2> loads;
  loads.node_forces = uniform_load(flag, 1, 0.1);
  for (int step = 0; step < 200; ++step)
    stepper.advance(
        state, [&](double) { return loads; }, 0.01);
  NodeVectors<2> x = flag.rest();
  find_equilibrium(flag, loads, x);
  EXPECT_LT((state.x - x).norm(), 1e-6);
}

TEST(FlagAtTheExtremes, FoldsToAHundredAndSeventyDegreesHoweverStiffItsStretch) {
  // Turn the held end of a cantilever: its free end is pulled over by a moment, as a pair of loads.
  for (const double K_S : {1e5, 1e8}) {
    const Flag<2> flag(FlagMesh(uniform_chord(101), cantilever), {1, 1, K_S, 0.3, 0});
    NodeVectors<2> x = flag.rest();
    FlagLoads<2> loads;
    loads.node_forces = NodeVectors<2>::Zero(2, 101);
    loads.node_forces(0, 100) = -40;
    loads.node_forces(1, 100) = 4;
    EXPECT_LE(find_equilibrium(flag, loads, x).iterations, several) << K_S;
    const Eigen::Vector2d end = x.col(100) - x.col(99);
    EXPECT_GT(std::atan2(end[1], end[0]), 170 * pi / 180) << K_S;
  }
}

template <int dim>
bool is_stable(const Flag<dim>& flag, const NodeVectors<dim>& x, const FlagLoads<dim>& loads) {
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({x, x}, loads, 0, *tangent);
  return tangent->factor_if_definite();
}

// Of the end of an inextensible column under `share` of Euler's load (Timoshenko & Gere 1961,
// section 2.7): 2 k/K(k), where K(k) = pi/2 share^1/2.
double deflection_of_buckled_elastica(double share) {
  const double K = pi / 2 * std::sqrt(share);
  double low = 0;
  double high = 1;
  while (high - low > 1e-12) {
    const double k = (low + high) / 2;
    (std::comp_ellint_1(k) < K ? low : high) = k;
  }
  return 2 * low / K;
}

// A cantilever column buckles at pi^2/4 K_B/L^2. Across it: a small load, almost none, none at all,
// where the straight column is an equilibrium too.
TEST(FlagAtTheExtremes, BucklesUnderTheLoadOfEuler) {
  const auto deflection = [](double share, double across) {
    const Flag<2> flag(FlagMesh(uniform_chord(81), cantilever), {1, 1, 1e5, 0.3, 0});
    NodeVectors<2> x = flag.rest();
    FlagLoads<2> loads;
    loads.node_forces = NodeVectors<2>::Zero(2, 81);
    loads.node_forces(0, 80) = -share * pi * pi / 4;
    loads.node_forces(1, 80) = across;
    EXPECT_LE(find_equilibrium(flag, loads, x).iterations, several) << share << ' ' << across;
    EXPECT_TRUE(is_stable(flag, x, loads)) << share << ' ' << across;
    return std::abs(x(1, 80));
  };
  for (const double across : {1e-3, 1e-6, 0.0}) {
    EXPECT_LT(deflection(0.9, across), 0.01) << across;
    // The grid's own error, and what the load across adds to a compliance of about 1.
    const double tolerance = 5e-4 + across;
    for (const double share : {1.1, 5.0})
      EXPECT_NEAR(deflection(share, across), deflection_of_buckled_elastica(share), tolerance)
          << across;
  }
}

TEST(FlagAtTheExtremes, BucklesAsAPlate) {
  const EdgeConditions edges{Edge::clamped, Edge::free, Edge::free, Edge::free};
  const Flag<3> flag(FlagMesh(uniform_chord(21), 11, 1.0, edges), {1, 1, 1e5, 0.3, 0});
  NodeVectors<3> x = flag.rest();
  FlagLoads<3> loads;
  loads.node_forces = uniform_load(flag, 1, -30);
  EXPECT_LE(find_equilibrium(flag, loads, x).iterations, several);
  EXPECT_TRUE(is_stable(flag, x, loads));
  EXPECT_GT(x.row(2).cwiseAbs().maxCoeff(), 0.3);
}

TEST(FlagAtTheExtremes, HalvesAStepThatIsAHundredTimesTooLarge) {
  const Flag<2> flag(FlagMesh(uniform_chord(41), pendulum), {1, 1e-4, 1e4, 0.3, 0});
  FlagStepper<2> stepper(flag, TimeScheme::energy_conserving);
  FlagState<2> state = stepper.start();
  const StepSummary step = stepper.advance(
      state, [](double) { return weight(0, -1); }, 0.5);
  EXPECT_GT(step.parts, 1);
  EXPECT_DOUBLE_EQ(state.t, 0.5);
  EXPECT_TRUE(state.x.allFinite());
}

TEST(FlagAtTheExtremes, StopsWithASentenceWhereNoStepConverges) {
  const Flag<2> flag(FlagMesh(uniform_chord(41), pendulum), {1, 0, 1e8, 0.3, 0});
  NewtonSettings settings;
  settings.most_iterations = 1;  // no step can converge
  settings.most_halvings = 3;
  FlagStepper<2> stepper(flag, TimeScheme::energy_conserving, settings);
  FlagState<2> state = stepper.start();
  try {
    stepper.advance(
        state, [](double) { return weight(0, -1); }, 0.5);
    FAIL();
  } catch (const SolverError& fault) {
    EXPECT_NE(std::string(fault.what()).find("t = 0 "), std::string::npos) << fault.what();
    EXPECT_NE(std::string(fault.what()).find("smaller dt"), std::string::npos) << fault.what();
  }
  EXPECT_EQ(state.t, 0);
  EXPECT_TRUE(state.x.allFinite());
}

TEST(FlagAtTheExtremes, SaysWhereALoadFindsNoEquilibrium) {
  const Flag<2> flag(FlagMesh(uniform_chord(21), pendulum), {1, 1e-4, 500, 0.3, 0});
  NodeVectors<2> x = flag.rest();
  FlagLoads<2> loads;  // a follower pressure on a pinned flag spins it
  loads.pressure = Eigen::VectorXd::Constant(flag.elements(), 1);
  EXPECT_THROW(find_equilibrium(flag, loads, x), SolverError);
}

// The two time schemes are of second order: the error of a swing falls by 4 as the step is halved.
// So it does where long and short steps alternate.
TEST(FlagStepper, IsOfSecondOrderInTime) {
  const Flag<2> flag(FlagMesh(uniform_chord(11), cantilever), {1, 0.1, 50, 0.3, 0.02});
  for (const TimeScheme scheme : {TimeScheme::energy_conserving, TimeScheme::backward_difference})
    for (const double unequal : {0.0, 0.25}) {
      const auto end = [&](double dt) {
        FlagStepper<2> stepper(flag, scheme, {.tolerance = 1e-13});
        FlagState<2> state = stepper.start();
        const long steps = std::lround(1 / dt);
        for (long n = 0; n < steps; ++n)
          stepper.advance(
              state, [](double t) { return weight(0.2, std::sin(t)); },
              dt * (1 + (n % 2 == 0 ? unequal : -unequal)));
        return NodeVectors<2>(state.x);
      };
      const NodeVectors<2> coarse = end(0.001), medium = end(0.0005), fine = end(0.00025);
      EXPECT_GE(order((coarse - medium).norm(), (medium - fine).norm(), 2), 1.9) << unequal;
    }
}

// The paper's swinging membrane (figure 24) on a coarse grid, through the bottom of its swing: all
// energies, what the damping took among them. The energy-conserving steps keep their sum to the
// tolerance of Newton's method; backward differences lose it at second order, and under 0.1 % of
// the kinetic energy.
TEST(SwingingMembrane, KeepsItsEnergyOrLosesItAtSecondOrder) {
  const Flag<3> flag(
      FlagMesh(uniform_chord(13), 9, 1.0, {Edge::pinned, Edge::free, Edge::free, Edge::free}),
      {1, 0.01, 100, 0.3, 0.001});
  FlagLoads<3> loads;
  loads.gravity = {0, 0, -1};
  const auto worst = [&](TimeScheme scheme, double dt) {
    FlagStepper<3> stepper(flag, scheme, {.tolerance = 1e-11, .contraction = 0.1});
    FlagState<3> state = stepper.start();
    double drift = 0;
    while (state.t < 1.5) {
      stepper.advance(
          state, [&](double) { return loads; }, dt);
      const double total = flag.energies(state.x, state.v, loads).total() + state.dissipated;
      drift = std::max(drift, std::abs(total));
    }
    return drift;
  };
  constexpr double kinetic = 0.5;  // at the bottom
  EXPECT_LT(worst(TimeScheme::energy_conserving, 0.02), 1e-7 * kinetic);
  const double coarse = worst(TimeScheme::backward_difference, 0.002);
  const double fine = worst(TimeScheme::backward_difference, 0.001);
  EXPECT_LT(fine, 1e-3 * kinetic);
  EXPECT_GE(order(coarse, fine, 2), 1.8);
}

}  // namespace
}  // namespace pennon::dns

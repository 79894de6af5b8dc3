// The fluid where it was not made for: it stays bounded, or stops with a sentence.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "common/errors.hpp"
#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

struct Outcome {
  std::string sentence;  // of the error; empty where the run came to its end
  double drag = 0, fastest = 0, least_area = 1;
  int pressure_iterations = 0;

  bool finished() const { return sentence.empty(); }
};

Outcome outcome(const FluidCase& settings, const PointMotion& motion, double dt, double t_end) {
  Outcome found;
  try {
    FluidRun run(settings, motion);
    while (run.state().t < t_end - dt / 2) run.step(dt);
    found.drag = 2 * run.force()[1];
    found.least_area = run.last().least_area;
    found.pressure_iterations = run.most_pressure_iterations();
    for (const Field<double>& u : run.state().u)
      run.at_cells([&](int plane, int j, int i) {
        found.fastest = std::max(found.fastest, std::abs(u.row(plane, j)[i]));
      });
  } catch (const SolverError& error) {
    found.sentence = error.what();
  }
  return found;
}

PointMotion wave(double k_x) {
  return [k_x](double t, double x, double y) -> std::array<double, 2> {
    const double begun = t * t * t / (0.03 + t * t * t);
    return {0, 0.1 * y * std::sin(5 * y - 5 * t) * (1 + 0.5 * std::cos(k_x * x)) * begun};
  };
}

FluidCase coarse(double Re) {
  FluidCase settings;
  settings.grid = {30, 60, 8, 0.03, 0};
  settings.parameters = {Re, 0};
  return settings;
}

// No velocity of these flows is beyond the stream's by more than half.
constexpr double bound = 1.5;

// At Re = 1 the plate's drag is still that of the triple deck to 5 %; at 10,000 the boundary layer
// is one cell thick, and the drag is a third high.
TEST(Extremes, OfReynoldsNumbersFromOneToTenThousandRun) {
  for (const double Re : {1.0, 10.0, 1e4}) {
    const double theory = 2 * (1.328 / std::sqrt(Re) + 2.67 * std::pow(Re, -7.0 / 8));
    const Outcome plate = outcome(coarse(Re), at_rest, 0.02, 4);
    EXPECT_TRUE(plate.finished()) << plate.sentence;
    EXPECT_LT(plate.fastest, bound);
    EXPECT_NEAR(plate.drag / theory, 1, Re < 1e4 ? 0.1 : 0.35) << Re;
    const Outcome flag = outcome(coarse(Re), wave(0), 0.01, 1);
    EXPECT_TRUE(flag.finished()) << flag.sentence;
    EXPECT_LT(flag.fastest, bound);
  }
}

// At Re = 100,000 the coarse grid has less than one cell in the boundary layer: it says so, by a
// solver that does not converge, at a time it names. A finer wall makes it run.
TEST(Extremes, OfAReynoldsNumberBeyondTheGridStopWithASentence) {
  const Outcome under_resolved = outcome(coarse(1e5), at_rest, 0.02, 4);
  EXPECT_FALSE(under_resolved.finished());
  EXPECT_NE(under_resolved.sentence.find("at t = "), std::string::npos) << under_resolved.sentence;
  FluidCase resolved = coarse(1e5);
  resolved.grid = {60, 120, 8, 0.002, 0};
  const Outcome plate = outcome(resolved, at_rest, 0.005, 1);
  EXPECT_TRUE(plate.finished()) << plate.sentence;
  EXPECT_LT(plate.fastest, bound);
}

// Ten times a step of 0.01 (Courant numbers of hundreds at the edges) changes the drag of a
// flapping flag by less than 5 %; fifty times is a wrong answer, but a bounded one.
TEST(Extremes, OfTheStepStayBounded) {
  const Outcome usual = outcome(coarse(1000), wave(0), 0.01, 3),
                large = outcome(coarse(1000), wave(0), 0.1, 3),
                huge = outcome(coarse(1000), wave(0), 0.5, 3);
  ASSERT_TRUE(usual.finished() && large.finished() && huge.finished())
      << usual.sentence << large.sentence << huge.sentence;
  EXPECT_LT(large.fastest, bound);
  EXPECT_NEAR(large.drag / usual.drag, 1, 0.05);
  EXPECT_LT(huge.fastest, 20);
}

// A span of a tenth of the chord and of fifty.
TEST(Extremes, OfTheSpanRun) {
  for (const double gamma : {0.1, 50.0}) {
    FluidCase settings = coarse(1000);
    settings.planes = 8;
    settings.span = gamma;
    const Outcome found = outcome(settings, wave(2 * pi / gamma), 0.01, 0.6);
    EXPECT_TRUE(found.finished()) << found.sentence;
    EXPECT_LT(found.fastest, bound);
    EXPECT_LE(found.pressure_iterations, 16) << gamma;  // 12 and 3
  }
}

TEST(Extremes, OfTheGridRunWithEightCellsEitherWay) {
  FluidCase settings = coarse(1000);
  settings.grid = {8, 8, 8, 0.1, 0};
  for (const PointMotion& motion : {PointMotion(at_rest), wave(0)}) {
    const Outcome found = outcome(settings, motion, 0.02, 4);
    EXPECT_TRUE(found.finished()) << found.sentence;
    EXPECT_LT(found.fastest, bound);
  }
}

// A flag that bends to a slope of 8 within a hundredth of a time unit, or on and on: the run stops
// where a solver gives up or the grid folds, and says so.
TEST(Extremes, OfTheMotionStopWithASentence) {
  const PointMotion bend = [](double t, double, double y) -> std::array<double, 2> {
    return {0, t * y * std::sin(8 * y)};
  };
  const Outcome mild = outcome(coarse(1000), bend, 0.01, 0.2);
  EXPECT_TRUE(mild.finished()) << mild.sentence;
  EXPECT_GT(mild.least_area, 0.2);
  const PointMotion jump = [&](double t, double x, double y) { return bend(100 * t, x, y); };
  const Outcome wild = outcome(coarse(1000), jump, 0.01, 1);
  ASSERT_FALSE(wild.finished());
  EXPECT_NE(wild.sentence.find("at t = "), std::string::npos) << wild.sentence;
}

}  // namespace
}  // namespace pennon::dns

/// The shape a flag starts from: along its length, and of one strain along the span.
#include "dns/run/initial_shape.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"

namespace pennon::dns {
namespace {

constexpr double span = 1;

FlagMesh mesh(int stations) {
  return {{0, 0.25, 0.5, 0.75, 1}, stations, span, {}};
}

// A narrow ridge along the chord.
ShapeFunction ridge(double height) {
  return [=](double x, double y) {
    return height * y * y * std::exp(20 * (std::cos(2 * std::numbers::pi * x / span) - 1));
  };
}

// The lengths between the stations at the chordwise index j, across the seam too.
Eigen::ArrayXd lengths(const FlagMesh& mesh, const NodeVectors<3>& x, int j) {
  Eigen::ArrayXd found(mesh.stations());
  for (int m = 0; m < mesh.stations(); ++m) {
    Eigen::Vector3d step =
        x.col(mesh.index((m + 1) % mesh.stations(), j)) - x.col(mesh.index(m, j));
    if (m + 1 == mesh.stations()) step[0] += span;
    found[m] = step.norm();
  }
  return found;
}

TEST(FlagInitialShape, HasOneStrainAlongTheSpan) {
  const FlagMesh of_24 = mesh(24);
  for (const double height : {1e-6, 0.02, 0.05, 0.06, 0.07}) {
    const NodeVectors<3> x = initial_shape<3>({}, ridge(height), of_24);
    for (int j = 1; j < of_24.chord_nodes(); ++j) {
      const Eigen::ArrayXd found = lengths(of_24, x, j);
      EXPECT_NEAR(found.maxCoeff() / found.minCoeff(), 1, 1e-12) << height;
      EXPECT_GE(found.minCoeff(), span / 24 * (1 - 1e-12));
    }
  }
}

TEST(FlagInitialShape, RefusesWhatIsSteeperAlongTheSpanThanTheFlagIsLong) {
  EXPECT_THAT(test::failure_of<InputError>([] { initial_shape<3>({}, ridge(0.1), mesh(24)); }),
              testing::HasSubstr("dns.initial: makes a shape that along the span, at y = "));
}

}  // namespace
}  // namespace pennon::dns

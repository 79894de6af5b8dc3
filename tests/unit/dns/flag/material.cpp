/// The energies of a material whose stiffness differs along chord and span.
#include "dns/flag/material.hpp"

#include <gtest/gtest.h>

#include <random>

#include "dns/flag/bending_form.hpp"
#include "dns/flag/stretch.hpp"

namespace pennon::dns {
namespace {

constexpr int chord_nodes = 7, stations = 6;
constexpr double span = 1.5, rounding = 1e-12;

FlagMesh free_mesh() {
  return {uniform_chord(chord_nodes), stations, span,
          EdgeConditions{Edge::free, Edge::free, Edge::free, Edge::free}};
}

double whole_energy(const Stretch<3>& stretch, const NodeVectors<3>& x) {
  const auto energy = stretch.energy(x);
  return energy.two_d + energy.three_d;
}

constexpr StretchEnergy woven{.stiffness = 40, .spanwise = 0.4, .coupling = 0.1, .shear = 0.2};

TEST(StretchEnergy, HasTheStiffnessOfEachDirection) {
  const Stretch<3> stretch(free_mesh(), woven);
  constexpr double e_1 = 0.02, e_2 = 0.03, shear = 0.01;
  NodeVectors<3> x = rest<3>(free_mesh());
  x.row(0) *= 1 + e_2;
  x.row(1) *= 1 + e_1;
  const double strained = woven.stiffness / 2 * span *
                          (e_1 * e_1 + woven.spanwise * e_2 * e_2 + 2 * woven.coupling * e_1 * e_2);
  EXPECT_NEAR(whole_energy(stretch, x), strained, rounding * strained);
  // Turned chordwise lines: their strain is the root's, the shear is the turn.
  x = rest<3>(free_mesh());
  x.row(0) += shear * x.row(1);
  const double along = std::hypot(1, shear) - 1;
  const double sheared = woven.stiffness / 2 * span * (along * along + woven.shear * shear * shear);
  EXPECT_NEAR(whole_energy(stretch, x), sheared, rounding * sheared);
}

TEST(StretchEnergy, HasItsGradientAsForces) {
  const Stretch<3> stretch(free_mesh(), woven);
  std::mt19937 engine(3);
  const auto noise = [&](double size) {
    NodeVectors<3> vectors(3, free_mesh().nodes());
    for (double& value : vectors.reshaped())
      value = std::uniform_real_distribution<double>(-size, size)(engine);
    return vectors;
  };
  const NodeVectors<3> x = rest<3>(free_mesh()) + noise(0.03), along = noise(1);
  constexpr double step = 1e-6;
  const double by_difference =
      (whole_energy(stretch, x + step * along) - whole_energy(stretch, x - step * along)) /
      (2 * step);
  NodeVectors<3> forces = NodeVectors<3>::Zero(3, x.cols());
  stretch.add_forces({x, x}, forces);
  constexpr double difference_error = 1e-7;
  EXPECT_NEAR(-forces.cwiseProduct(along).sum(), by_difference,
              difference_error * std::abs(by_difference));
}

// z = a y^2/2 + b x^2/2 + c x y has curvatures a, b and the twist c, which differences give
// exactly. At a free edge the curvature across it is what makes the energy least.
TEST(BendingEnergy, HasTheStiffnessOfEachDirection) {
  constexpr BendingEnergy ribbed{.stiffness = 3, .spanwise = 0.5, .coupling = 0.2, .twist = 0.7};
  constexpr double a = 0.3, b = -0.4, c = 0.25;
  const FlagMesh mesh = free_mesh();
  NodeVectors<3> x = rest<3>(mesh);
  double expected = ribbed.stiffness * ribbed.twist * c * c * span;
  for (int i = 0; i < stations; ++i)
    for (int j = 0; j < chord_nodes; ++j) {
      const double s_1 = mesh.y(j), s_2 = mesh.x(i);
      x(2, mesh.index(i, j)) = a * s_1 * s_1 / 2 + b * s_2 * s_2 / 2 + c * s_1 * s_2;
      const bool knows_along = j > 0 && j + 1 < chord_nodes,
                 knows_across = i > 0 && i + 1 < stations;
      // -coupling/spanwise a, and -coupling b.
      const double along = knows_along ? a : knows_across ? -ribbed.coupling * b : 0;
      const double across = knows_across  ? b
                            : knows_along ? -ribbed.coupling / ribbed.spanwise * a
                                          : 0;
      expected += ribbed.stiffness / 2 * mesh.area(i, j) *
                  (along * along + ribbed.spanwise * across * across +
                   2 * ribbed.coupling * along * across);
    }
  EXPECT_NEAR(bending_form(mesh, ribbed).energy(x), expected, rounding * expected);
}

TEST(IsotropicMaterial, HasTheEnergiesOfSection3_2) {
  const FlagMaterial plate{.mu = 1, .K_B = 2, .K_S = 300, .nu_s = 0.3, .damping = 0.1};
  const StretchEnergy stretch = plate.stretch();
  EXPECT_EQ(stretch.stiffness, 300);
  EXPECT_EQ(stretch.spanwise, 1);
  EXPECT_EQ(stretch.coupling, 0.3);
  EXPECT_EQ(stretch.shear, 0.35);
  EXPECT_EQ(stretch.damping, 0.1);
  const BendingEnergy bending = plate.bending();
  EXPECT_EQ(bending.stiffness, 2);
  EXPECT_EQ(bending.spanwise, 1);
  EXPECT_EQ(bending.coupling, 0.3);
  EXPECT_EQ(bending.twist, 0.7);
}

}  // namespace
}  // namespace pennon::dns

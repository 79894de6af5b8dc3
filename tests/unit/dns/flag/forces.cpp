/// The discrete flag's identities: forces are the gradient of the energy, the tangent is the
/// derivative of the forces, rigid motion costs nothing, free flags keep their momenta.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <limits>

#include "dns/flag/stepper.hpp"
#include "tests/support/flags.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double difference = 1e-6;  // of central differences
constexpr double difference_error =
    1e-7;  // difference^2 and epsilon/difference, with their factors
constexpr double roundoff = 1e3 * epsilon;  // relative to the energies at work

// A clustered chord, to leave no place where equal spacings could hide a fault.
std::vector<double> clustered(int nodes) {
  std::vector<double> y = uniform_chord(nodes);
  for (double& value : y) value = value + 0.2 * value * (1 - value) * (0.7 - value);
  return y;
}

const FlagMaterial soft{0.5, 0.02, 30, 0.3, 0.1};

FlagMesh flat(EdgeConditions edges) {
  return {clustered(9), edges};
}
FlagMesh spanned(EdgeConditions edges) {
  return {clustered(6), 5, 1.3, edges};
}

const std::vector<EdgeConditions> span_edges = {
    {Edge::clamped, Edge::free, Edge::periodic, Edge::periodic},
    {Edge::pinned, Edge::free, Edge::free, Edge::clamped},
    {Edge::free, Edge::clamped, Edge::clamped, Edge::pinned},
    {Edge::free, Edge::free, Edge::free, Edge::free}};

template <int dim>
FlagLoads<dim> all_loads(const Flag<dim>& flag) {
  FlagLoads<dim> loads;
  loads.gravity.setLinSpaced(0.2, 0.7);
  loads.pressure = Eigen::VectorXd::LinSpaced(flag.elements(), -1, 2);
  loads.node_forces = noise(flag, 0.1, 5);
  return loads;
}

template <int dim>
void expect_gradient(const FlagMesh& mesh) {
  FlagMaterial undamped = soft;
  undamped.damping = 0;
  const Flag<dim> flag(mesh, undamped);
  const NodeVectors<dim> x = flag.rest() + noise(flag, 0.04, 1);
  const NodeVectors<dim> along = noise(flag, 1, 2);
  const NodeVectors<dim> still = NodeVectors<dim>::Zero(dim, mesh.nodes());
  FlagLoads<dim> gravity;
  gravity.gravity.setConstant(0.4);
  const auto energy = [&](const NodeVectors<dim>& at) {
    return flag.energies(at, still, gravity).total();
  };
  const double by_difference =
      (energy(x + difference * along) - energy(x - difference * along)) / (2 * difference);
  const double by_forces = -flag.forces({x, x}, gravity).cwiseProduct(along).sum();
  EXPECT_NEAR(by_forces, by_difference, difference_error * std::abs(by_difference));
}

template <int dim>
void expect_tangent(const FlagMesh& mesh, Pairing pairing) {
  const Flag<dim> flag(mesh, soft);
  const FlagLoads<dim> loads = all_loads(flag);
  const NodeVectors<dim> start = flag.rest() + noise(flag, 0.03, 3);
  const NodeVectors<dim> end = flag.rest() + noise(flag, 0.05, 4);
  const NodeVectors<dim> along = at_free_nodes(flag, noise(flag, 1, 6));
  const NodeVectors<dim> plus = end + difference * along;
  const NodeVectors<dim> minus = end - difference * along;
  const double dt = 0.1;
  const double factor = 7;  // d(velocity)/d(end)
  const NodeVectors<dim> rest = noise(flag, 1, 12);
  const auto forces = [&](const NodeVectors<dim>& at) {
    const NodeVectors<dim> v = factor * at + rest;
    return flag.forces({start, at, pairing, dt, &v, factor}, loads);
  };
  const NodeVectors<dim> by_difference = (forces(minus) - forces(plus)) / (2 * difference);
  const NodeVectors<dim> velocity = factor * end + rest;
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({start, end, pairing, dt, &velocity, factor}, loads, 0, *tangent);
  const auto packed = [&](const NodeVectors<dim>& vectors) {
    Eigen::VectorXd unknowns(static_cast<Eigen::Index>(dim * tangent->free_nodes().size()));
    for (std::size_t n = 0; n < tangent->free_nodes().size(); ++n)
      unknowns.segment<dim>(static_cast<Eigen::Index>(dim * n)) =
          vectors.col(tangent->free_nodes()[n]);
    return unknowns;
  };
  const Eigen::VectorXd by_tangent = tangent->matrix() * packed(along);
  EXPECT_LT((by_tangent - packed(by_difference)).norm(), difference_error * by_tangent.norm());
}

TEST(FlagForces, AreTheGradientOfTheEnergy) {
  expect_gradient<2>(flat({Edge::pinned, Edge::free}));
  expect_gradient<2>(flat({Edge::clamped, Edge::clamped}));
  for (const EdgeConditions& edges : span_edges) expect_gradient<3>(spanned(edges));
}

TEST(FlagTangent, IsTheDerivativeOfTheForces) {
  for (const Pairing pairing : {Pairing::end, Pairing::discrete_gradient}) {
    expect_tangent<2>(flat({Edge::pinned, Edge::free}), pairing);
    expect_tangent<2>(flat({Edge::clamped, Edge::free}), pairing);
    for (const EdgeConditions& edges : span_edges) expect_tangent<3>(spanned(edges), pairing);
  }
}

TEST(FlagTangent, IsSymmetricAtTheEndAndAtRest) {
  const Flag<3> flag(spanned(span_edges[1]), soft);
  const NodeVectors<3> x = flag.rest() + noise(flag, 0.05, 4);
  const auto tangent = flag.tangent_matrix();
  tangent->set_zero();
  flag.add_tangent({x, x}, {}, 0, *tangent);
  const Eigen::MatrixXd K = tangent->matrix();
  EXPECT_LT((K - K.transpose()).norm(), roundoff * K.norm());
}

template <int dim>
void expect_exact_work(const FlagMesh& mesh) {
  FlagMaterial undamped = soft;
  undamped.damping = 0;
  const Flag<dim> flag(mesh, undamped);
  const NodeVectors<dim> start = flag.rest() + noise(flag, 0.1, 7);
  const NodeVectors<dim> end = flag.rest() + noise(flag, 0.1, 8);
  const NodeVectors<dim> still = NodeVectors<dim>::Zero(dim, mesh.nodes());
  const double work = flag.forces({start, end, Pairing::discrete_gradient, 0.1}, {})
                          .cwiseProduct(end - start)
                          .sum();
  const double before = flag.energies(start, still, {}).total();
  const double after = flag.energies(end, still, {}).total();
  EXPECT_NEAR(work, before - after, roundoff * (before + after));
}

TEST(DiscreteGradient, DoesTheWorkOfTheEnergyChangeHoweverFarTheStep) {
  expect_exact_work<2>(flat({Edge::clamped, Edge::free}));
  for (const EdgeConditions& edges : span_edges) expect_exact_work<3>(spanned(edges));
}

TEST(StressedFlag, KeepsItsEnergyUnderRigidMotion) {
  const Flag<3> flag(spanned(all_edges(Edge::free)), soft);
  const NodeVectors<3> x = flag.rest() + noise(flag, 0.05, 9);
  const Eigen::Matrix3d turn =
      Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  const NodeVectors<3> moved = (turn * x).colwise() + Eigen::Vector3d(3, -1, 2);
  const NodeVectors<3> still = NodeVectors<3>::Zero(3, x.cols());
  const double energy = flag.energies(x, still, {}).total();
  EXPECT_NEAR(flag.energies(moved, still, {}).total(), energy, roundoff * energy);
  EXPECT_LT((flag.forces({moved, moved}, {}) - turn * flag.forces({x, x}, {})).norm(),
            roundoff * flag.forces({x, x}, {}).norm());
}

// x_1 and x_2 are constant: the strains are those of the gradient everywhere.
TEST(StretchedFlag, HasTheStrainsOfItsDeformation) {
  Eigen::Matrix3d gradient;
  gradient << 1.1, 0.2, 0, 0.1, 0.9, 0, 0.3, -0.4, 1;
  const Flag<3> flag(spanned(span_edges[3]), soft);
  const Eigen::Matrix3Xd strains = flag.stretch().strains(gradient * flag.rest());
  ASSERT_EQ(strains.cols(), flag.elements());
  const Eigen::Vector3d along_span = gradient.col(0);
  const Eigen::Vector3d along_chord = gradient.col(1);
  const Eigen::Vector3d expected{along_chord.norm() - 1, along_span.norm() - 1,
                                 along_chord.dot(along_span)};
  EXPECT_LT((strains.colwise() - expected).cwiseAbs().maxCoeff(), roundoff);

  const Flag<2> line(flat({Edge::pinned, Edge::free}), soft);
  const Eigen::Matrix3Xd along = line.stretch().strains(1.25 * line.rest());
  ASSERT_EQ(along.cols(), line.elements());
  EXPECT_LT((along.colwise() - Eigen::Vector3d{0.25, 0, 0}).cwiseAbs().maxCoeff(), roundoff);
}

TEST(FlagAtRest, HasNoEnergyAndNoForce) {
  for (const EdgeConditions& edges : span_edges) {
    const Flag<3> flag(spanned(edges), soft);
    const NodeVectors<3> x = flag.rest();
    const FlagEnergies energies = flag.energies(x, NodeVectors<3>::Zero(3, x.cols()), {});
    EXPECT_NEAR(energies.total(), 0, roundoff);
    EXPECT_LT(flag.forces({x, x}, {}).cwiseAbs().maxCoeff(), 1e3 * roundoff);
  }
}

TEST(FreeFlag, KeepsEnergyMomentumAndAngularMomentum) {
  FlagMaterial undamped = soft;
  undamped.damping = 0;
  const Flag<3> flag(spanned(all_edges(Edge::free)), undamped);
  FlagStepper<3> stepper(flag, TimeScheme::energy_conserving, {.tolerance = 1e-13});
  FlagState<3> state = stepper.start(flag.rest() + noise(flag, 0.05, 10));
  state.v = noise(flag, 0.5, 11);
  const auto momentum = [&] { return Eigen::Vector3d(state.v * flag.mass()); };
  const auto angular_momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int n = 0; n < flag.mesh().nodes(); ++n)
      sum +=
          flag.mass()[n] * Eigen::Vector3d(state.x.col(n)).cross(Eigen::Vector3d(state.v.col(n)));
    return sum;
  };
  const double energy = flag.energies(state.x, state.v, {}).total();
  const Eigen::Vector3d p = momentum();
  const Eigen::Vector3d l = angular_momentum();
  for (int step = 0; step < 200; ++step)
    stepper.advance(
        state, [](double) { return FlagLoads<3>{}; }, 0.02);
  EXPECT_NEAR(flag.energies(state.x, state.v, {}).total(), energy, 1e-9 * energy);
  EXPECT_LT((momentum() - p).norm(), 1e-11);
  EXPECT_LT((angular_momentum() - l).norm(), 1e-11);
}

TEST(DampedFlag, LosesWhatItsDampingTakes) {
  const Flag<3> flag(spanned(all_edges(Edge::free)), soft);
  FlagStepper<3> stepper(flag, TimeScheme::energy_conserving, {.tolerance = 1e-13});
  FlagState<3> state = stepper.start(flag.rest() + noise(flag, 0.05, 10));
  const double energy = flag.energies(state.x, state.v, {}).total();
  for (int step = 0; step < 100; ++step)
    stepper.advance(
        state, [](double) { return FlagLoads<3>{}; }, 0.02);
  EXPECT_GT(state.dissipated, 0.1 * energy);
  EXPECT_NEAR(flag.energies(state.x, state.v, {}).total() + state.dissipated, energy,
              1e-9 * energy);
}

TEST(LoadedFlag, GainsTheWorkOfItsLoads) {
  FlagMaterial undamped = soft;
  undamped.damping = 0;
  const Flag<2> flag(flat({Edge::clamped, Edge::free}), undamped);
  FlagStepper<2> stepper(flag, TimeScheme::energy_conserving, {.tolerance = 1e-13});
  FlagState<2> state = stepper.start();
  FlagLoads<2> loads;
  loads.pressure = Eigen::VectorXd::Constant(flag.elements(), 0.3);
  loads.node_forces = uniform_load(flag, 0, 0.2);
  for (int step = 0; step < 100; ++step)
    stepper.advance(
        state, [&](double) { return loads; }, 0.02);
  const double energy = flag.energies(state.x, state.v, loads).total();
  EXPECT_GT(std::abs(state.work), 1e-3);
  EXPECT_NEAR(energy, state.work, 1e-9 * std::abs(state.work) + 1e-12);
}

}  // namespace
}  // namespace pennon::dns

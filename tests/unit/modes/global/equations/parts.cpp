// The parts of the global modes' operator, one by one.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>
#include <random>

#include "common/errors.hpp"
#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/base_flow.hpp"
#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/equations/grid_response.hpp"
#include "modes/global/equations/jacobian.hpp"
#include "modes/global/solve/sensitivity.hpp"
#include "modes/global/solve/spectrum.hpp"
#include "modes/normal/in_vacuo.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;
using Matrix = Eigen::SparseMatrix<Complex>;

const dns::OGridSettings small_grid = {.n_rho = 10, .n_theta = 24, .R = 3, .wall_spacing = 0.12};

std::vector<bool> inflow_upstream(const dns::OGrid& grid) {
  std::vector<bool> is_inflow(grid.n_theta());
  for (int i = 0; i < grid.n_theta(); ++i) is_inflow[i] = std::cos(grid.theta_centre(i)) < 0;
  return is_inflow;
}

Eigen::VectorXd random_vector(Eigen::Index n) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(-1, 1);
  return Eigen::VectorXd::NullaryExpr(n, [&] { return number(random); });
}

TEST(GlobalJacobian, IsTheDifferenceOfTheEquationsForEitherSymmetry) {
  const dns::OGrid grid(small_grid);
  const PlaneParameters parameters{.Re = 50, .dt_of_pressure = 0.02};
  const BaseFlow base = base_flow(grid, parameters, 2);
  for (const Symmetry symmetry : {Symmetry::symmetric, Symmetry::antisymmetric}) {
    const HalfPlane unknowns(base.q.p.extent(), 2, symmetry);
    PlaneEquations<Complex> complex_equations(grid, parameters, 2);
    complex_equations.set_inflow(inflow_upstream(grid));
    const Jacobian J = jacobian(complex_equations, base.q, unknowns, false);
    PlaneEquations<double> equations(grid, parameters, 2);
    equations.set_inflow(inflow_upstream(grid));
    const Eigen::VectorXd direction = random_vector(unknowns.unknowns());
    constexpr double h = 1e-6;
    const auto residual_at = [&](double step) {
      PlaneFlow<double> q(base.q), change(base.q.p.extent(), 2), R(base.q.p.extent(), 2);
      unknowns.unpack<double>(step * direction, change);
      for (int f = 0; f < q.fields(); ++f)
        for (std::size_t k = 0; k < q.p.values().size(); ++k)
          q.field(f).values()[k] += change.field(f).values()[k];
      equations.evaluate(q, nullptr, R, nullptr);
      return unknowns.pack(R);
    };
    const Eigen::VectorXd difference = (residual_at(h) - residual_at(-h)) / (2 * h);
    EXPECT_LT((J.in_plane * direction - difference).norm(), 1e-7 * difference.norm());
  }
}

TEST(GlobalGridResponse, IsThatOfTheEllipticGridToASmallDisplacement) {
  const dns::OGrid grid(small_grid);
  const int node = 7, n_theta = grid.n_theta(), corner = n_theta / 2 - node;
  const Displacement<double> d =
      MovingCorners(Extent{1, grid.n_rho(), n_theta})
          .unpack<double>(grid_response(grid, n_theta / 2 + 1).col(node));
  constexpr double amplitude = 1e-5;
  Displacement<double> displacement(Extent{1, grid.n_rho(), n_theta});
  std::vector<double> y(static_cast<std::size_t>(n_theta)), z(y.size());
  z[static_cast<std::size_t>(corner)] = z[static_cast<std::size_t>(n_theta - corner)] = amplitude;
  dns::EllipticGrid(grid).follow(0, y.data(), z.data(), displacement, 1e-16, 300);
  constexpr double of_second_order = 1e3 * amplitude;  // over the square of the cells' size
  for (int j = 0; j <= grid.n_rho(); ++j)
    for (int i = 0; i < n_theta; ++i) {
      EXPECT_NEAR(displacement.y.row(0, j)[i] / amplitude, d.y.row(0, j)[i], of_second_order);
      EXPECT_NEAR(displacement.z.row(0, j)[i] / amplitude, d.z.row(0, j)[i], of_second_order);
    }
}

// What the equations of the whole plane say of a motion of all corners at once, by one complex step
// for each of its parts.
struct MotionAtOnce {
  const OGrid& grid;
  const BaseFlow& base;
  const LinearFluid& fluid;
  PlaneEquations<Complex> equations{grid, base.parameters, base.q.components()};
  PlaneFlow<Complex> q{complex_flow(base.q)}, R{q}, X{q};

  Displacement<Complex> step(const Eigen::VectorXd& zeta) const {
    const Eigen::VectorXcd corners = Complex(0, complex_step) * (fluid.G * zeta);
    return MovingCorners(base.q.p.extent()).unpack<Complex>(corners);
  }
  // -(R + of_X X) and the force, times of_R.
  void add(Complex of_R, Complex of_X, Eigen::VectorXcd& flow, Eigen::VectorXcd& force) {
    equations.evaluate(q, nullptr, R, q.components() > 2 ? &X : nullptr);
    fluid.flow.for_each([&](int f, int j, int i, Eigen::Index k) {
      flow[k] -= of_R * R.field(f).row(0, j)[i].imag() / complex_step;
      flow[k] -= of_X * X.field(f).row(0, j)[i].imag() / complex_step;
    });
    const Eigen::Index held = fluid.flow.columns() + 1 - fluid.flag_nodes;
    for (Eigen::Index s = 0; s < fluid.flow.columns(); ++s)
      for (const Eigen::Index node : {s - held, s + 1 - held})
        if (node >= 0)
          force[node] +=
              of_R * equations.forces().z[static_cast<std::size_t>(s)].imag() / (2 * complex_step);
  }
};

TEST(GlobalLinearFluid, KnowsWhatAMotionOfAllCornersAtOnceDoesToFlowAndForce) {
  for (const double k_x : {0.0, 2.0}) {
    const dns::OGrid grid({.n_rho = 22, .n_theta = 44, .R = 4, .wall_spacing = 0.03});
    const int components = k_x == 0 ? 2 : 3, nodes = grid.n_theta() / 2;
    const BaseFlow base =
        base_flow(grid, {.Re = 150, .U = 0.3, .dt_of_pressure = 0.01}, components);
    const LinearFluid fluid = linear_fluid(grid, base, nodes, k_x);
    MotionAtOnce motion{grid, base, fluid};
    motion.equations.set_inflow(base.is_inflow);
    const Displacement<Complex> still(base.q.p.extent());
    const Complex ik(0, k_x);
    const Eigen::VectorXd zeta = Eigen::VectorXd::Random(nodes);
    Eigen::VectorXcd flow = Eigen::VectorXcd::Zero(fluid.flow.unknowns()), by_velocity = flow,
                     force = Eigen::VectorXcd::Zero(nodes), force_by_velocity = force;
    const Displacement<Complex> step = motion.step(zeta);
    motion.equations.set_grid(step, nullptr);
    motion.add(1, -ik, flow, force);
    if (k_x != 0) {
      motion.equations.set_grid(still, &step);
      motion.add(ik, -ik * ik, flow, force);
    }
    motion.equations.set_grid(still, nullptr);
    motion.equations.set_grid_velocity(step);
    motion.add(1, -ik, by_velocity, force_by_velocity);
    EXPECT_LT((fluid.A_vz(zeta) - flow).norm(), 1e-11 * flow.norm());
    EXPECT_LT((fluid.A_vt(zeta) - by_velocity).norm(), 1e-11 * by_velocity.norm());
    EXPECT_LT((fluid.F_z * zeta - force).norm(), 1e-11 * force.norm());
    EXPECT_LT((fluid.F_t * zeta - force_by_velocity).norm(), 1e-11 * force_by_velocity.norm());
    const Complex lambda(0.3, 2);
    EXPECT_LT((fluid.flag_forcing(lambda, 3, 5).col(1) -
               (fluid.A_vz(Eigen::VectorXcd::Unit(nodes, 4)) +
                lambda * fluid.A_vt(Eigen::VectorXcd::Unit(nodes, 4))))
                  .norm(),
              1e-12 * flow.norm());
  }
}

// Frequencies of the flag by itself under the friction of Blasius' boundary layer.
std::vector<double> frequencies(int n_theta, double k_x, const dns::FlagMaterial& material,
                                double T_0) {
  dns::OGridSettings settings = small_grid;
  settings.n_theta = n_theta;
  const std::vector<double> chord = dns::coupled_chord(dns::OGrid(settings));
  SegmentForces<double> forces;
  forces.x.assign(chord.size() - 1, 0);
  for (std::size_t s = 0; s + 1 < chord.size(); ++s)
    forces.y.push_back(T_0 * (std::sqrt(chord[s + 1]) - std::sqrt(chord[s])));
  const FlagOperator flag =
      flag_operator(chord, dns::Edge::pinned, material, forces, k_x, 10 * n_theta);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
      flag.stiffness.real(), flag.mass.asDiagonal().toDenseMatrix());
  std::vector<double> omega(3);
  for (int k = 0; k < 3; ++k) omega[k] = std::sqrt(solver.eigenvalues()[k]);
  return omega;
}

void expect_modes_in_vacuo(double gamma, int n) {
  const FlagParameters parameters{.mu = 0.2, .K_B = 1e-3, .K_S = 1e5, .nu_s = 0.3, .gamma = gamma};
  const FlowParameters flow{.Re = 400};
  const dns::FlagMaterial material{.mu = 0.2, .K_B = 1e-3, .K_S = 1e5, .nu_s = 0.3};
  const NormalModes exact =
      in_vacuo_modes({{n}, 3}, parameters, flow, TensionProfile::blasius, 200);
  const double k_x = spanwise_wavenumber(n, parameters), T_0 = 1.3 / std::sqrt(flow.Re);
  const std::vector<double> coarse = frequencies(30, k_x, material, T_0),
                            fine = frequencies(60, k_x, material, T_0);
  for (std::size_t m = 0; m < 3; ++m) {
    const double omega = exact.modes[m].omega;
    EXPECT_NEAR(fine[m], omega, 0.01 * omega) << m;
    EXPECT_LT(std::abs(fine[m] - omega), 0.35 * std::abs(coarse[m] - omega)) << m;
  }
}

TEST(GlobalFlag, WithoutTheFluidHasTheModesInVacuoAtSecondOrder) {
  expect_modes_in_vacuo(1, 0);
}

TEST(GlobalFlag, WithoutTheFluidHasTheModesInVacuoOfWavesAlongTheSpan) {
  expect_modes_in_vacuo(1, 1);  // k_x = 2 pi, where the conditions of the free edge matter
}

TEST(GlobalSensitivity, IsTheDerivativeOfTheEigenvalue) {
  const dns::OGrid grid(small_grid);
  const std::vector<double> chord = dns::coupled_chord(grid);
  constexpr double k_x = 2;
  const BaseFlow base = base_flow(grid, {.Re = 100, .dt_of_pressure = 0.01}, 3);
  const FlagOf flag_of = [&](const dns::FlagMaterial& material, double share) {
    SegmentForces<double> forces = base.forces;
    for (double& pull : forces.y) pull *= share;
    return flag_operator(chord, dns::Edge::pinned, material, forces, k_x, 40);
  };
  const dns::FlagMaterial material{.mu = 0.4, .K_B = 2e-3};
  const auto operator_of = [&](const dns::FlagMaterial& its, double share) {
    return coupled_operator(grid, base, flag_of(its, share), k_x);
  };
  const CoupledOperator coupled = operator_of(material, 1);
  Eigenpair pair = eigenpair_near(coupled.assembled(), {0, 2.5});
  const SparsePencil adjoint = coupled.assembled().adjoint();
  set_adjoint(coupled, eigenpair_near(adjoint, std::conj(pair.lambda) + 1e-5).q, pair);
  EXPECT_LT(pair.adjoint_residual, 1e-11);
  normalise(coupled, pair);
  const auto difference = [&](const dns::FlagMaterial& more, const dns::FlagMaterial& less,
                              double share, double step) {
    const CoupledOperator high = operator_of(more, 1 + share), low = operator_of(less, 1 - share);
    return (eigenpair_near(high.assembled(), pair.lambda).lambda -
            eigenpair_near(low.assembled(), pair.lambda).lambda) /
           (2 * step);
  };
  const Sensitivity found = sensitivity(pair, coupled, material, flag_of);
  const auto expect_near = [](Complex derivative, Complex differenced) {
    EXPECT_LT(std::abs(derivative - differenced), 1e-4 * std::abs(differenced));
  };
  expect_near(found.mu,
              difference({.mu = 0.402, .K_B = 2e-3}, {.mu = 0.398, .K_B = 2e-3}, 0, 2e-3));
  expect_near(found.K_B,
              difference({.mu = 0.4, .K_B = 2.01e-3}, {.mu = 0.4, .K_B = 1.99e-3}, 0, 1e-5));
  expect_near(found.nu_s, difference({.mu = 0.4, .K_B = 2e-3, .nu_s = 0.302},
                                     {.mu = 0.4, .K_B = 2e-3, .nu_s = 0.298}, 0, 2e-3));
  expect_near(found.tension, difference(material, material, 5e-3, 5e-3));
}

TEST(GlobalSpectrum, InverseIterationFindsTheEigenvalueOfAPencilNextToTheTarget) {
  // diag(1, 2 + 3i, -5) q = lambda diag(1, 2, 0) q: 1, 1 + 1.5 i and infinity.
  Matrix A(3, 3), B(3, 3);
  A.insert(0, 0) = 1;
  A.insert(1, 1) = Complex(2, 3);
  A.insert(2, 2) = -5;
  B.insert(0, 0) = 1;
  B.insert(1, 1) = 2;
  const SparsePencil pencil(A, B);
  EXPECT_LT(std::abs(eigenpair_near(pencil, {0.8, 0.1}).lambda - 1.0), 1e-12);
  const Eigenpair pair = eigenpair_near(pencil, {1, 1.2});
  EXPECT_LT(std::abs(pair.lambda - Complex(1, 1.5)), 1e-12);
  EXPECT_LT(residual_of(pencil, pair), 1e-12);
}

TEST(GlobalSpectrum, MergesWhatTwoTargetsFoundTwiceAndKeepsTheBetter) {
  Spectrum spectrum;
  merge({{{1, 2}, {}, 1e-9}, {{3, 0}, {}, 1e-9}}, spectrum);
  merge({{{1, 2 + 1e-9}, {}, 1e-12}, {{2, 0}, {}, 1e-9}}, spectrum);
  ASSERT_EQ(spectrum.pairs.size(), 3u);
  EXPECT_EQ(spectrum.pairs[0].lambda, Complex(3, 0));
  EXPECT_EQ(spectrum.pairs[1].lambda, Complex(2, 0));
  EXPECT_EQ(spectrum.pairs[2].residual, 1e-12);
}

}  // namespace
}  // namespace pennon::modes::global

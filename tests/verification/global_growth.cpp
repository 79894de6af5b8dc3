// The linear growth of the simulation is the global eigenvalue: the simulation starts in the steady
// flow with a little of a global mode added, and goes on as that mode.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "modes/global/coupled_operator.hpp"
#include "modes/global/grid_response.hpp"
#include "modes/global/spectrum.hpp"
#include "tests/support/coupled.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double amplitude = 1e-6;

test::CoupledCase small_case() {
  test::CoupledCase small;
  small.grid = {.n_rho = 24, .n_theta = 48, .R = 4, .wall_spacing = 0.03};
  small.fluid.Re = 300;
  small.flag = {.mu = 0.3, .K_B = 1e-3, .K_S = 500, .damping = 0.02};
  small.tolerances = {.pressure = 1e-13, .velocity = 1e-14, .grid = 1e-13};
  small.coupling.tolerance = 1e-11;
  return small;
}

// A mode next to a target, and what it is a mode of.
struct ModeOfCase {
  dns::OGrid grid;
  BaseFlow base;
  CoupledOperator coupled;
  Eigenpair pair;

  ModeOfCase(const test::CoupledCase& simulation, double k_x, double dt, Complex target)
      : grid(simulation.grid),
        base(base_flow(grid,
                       {.Re = simulation.fluid.Re, .U = simulation.fluid.U, .tau = 2 * dt / 3},
                       k_x != 0 ? 3 : 2)),
        coupled(
            coupled_operator(grid, base,
                             flag_operator(dns::coupled_chord(grid), simulation.leading_edge,
                                           simulation.flag, base.forces, k_x, simulation.planes),
                             k_x)),
        pair(eigenpair_near(coupled.A, coupled.B, target)) {
    const Eigen::Index last = coupled.flag_nodes - 1;
    pair.q /= pair.q[coupled.zeta(last)];
  }
};

// The simulation at t = 0, in the steady flow and amplitude Re[q exp(i k_x x)].
template <int dim>
class Start {
 public:
  Start(const ModeOfCase& mode, const dns::Fluid& fluid, const dns::Flag<dim>& flag, double k_x,
        double dt)
      : mode_(mode), fluid_(fluid), flag_(flag), k_x_(k_x), dt_(dt) {}

  dns::CoupledState<dim> operator()(dns::CoupledState<dim> state) const {
    dns::FluidState& fluid = state.fluid;
    const std::vector<Displacement<double>> response = grid_response(mode_.grid);
    PlaneFlow<Complex> q(Extent{1, mode_.grid.n_rho(), mode_.grid.n_theta()},
                         mode_.base.q.components());
    const Eigen::VectorXcd flow = mode_.pair.q.head(mode_.coupled.flow.unknowns());
    mode_.coupled.flow.unpack<Complex>(flow, q);
    fluid.previous_dt = dt_;
    for (int plane = 0; plane < fluid_.extent().planes; ++plane) {
      for (std::size_t c = 0; c < fluid.u.size(); ++c) {
        place(plane, 0, mode_.base.q.u[c], q.u[c], fluid.u[c]);
        place(plane, -dt_, mode_.base.q.u[c], q.u[c], fluid.u_last[c]);
      }
      place(plane, 0, mode_.base.q.p, q.p, fluid.p);
      place(plane, -dt_, mode_.base.q.p, q.p, fluid.p_last);
      for (std::size_t n = 0; n < 3; ++n)
        place_grid(plane, -dt_ * static_cast<double>(n), response, fluid.grid[n]);
      for (int i = 0; i < fluid_.extent().n_theta; ++i)
        fluid.is_inflow[fluid_.extent().wall_face(plane, i)] =
            mode_.base.is_inflow[static_cast<std::size_t>(i)];
    }
    state.flag.x = positions(0);
    state.flag.previous_x = positions(-dt_);
    state.flag.v = velocities(0);
    state.flag.previous_v = velocities(-dt_);
    state.flag.previous_dt = dt_;
    return state;
  }

 private:
  Complex factor(double t, double x) const {
    return amplitude * std::exp(mode_.pair.lambda * t + Complex(0, k_x_ * x));
  }

  void place(int plane, double t, const Field<double>& base, const Field<Complex>& q,
             Field<double>& f) const {
    const Complex by = factor(t, fluid_.span().x(plane));
    for (int j = 0; j < base.extent().n_rho; ++j)
      for (int i = 0; i < base.extent().n_theta; ++i)
        f.row(plane, j)[i] = base.row(0, j)[i] + (by * q.row(0, j)[i]).real();
  }

  // The grid at rest where the flag's stretch leaves it is not known to the linear operator.
  void place_grid(int plane, double t, const std::vector<Displacement<double>>& response,
                  Displacement<double>& grid) const {
    const Complex by = factor(t, fluid_.span().x(plane));
    const Extent& extent = fluid_.extent();
    const auto held = static_cast<Eigen::Index>(response.size()) - mode_.coupled.flag_nodes;
    for (int j = 0; j <= extent.n_rho; ++j)
      for (int i = -2; i <= extent.n_theta + 1; ++i) {
        double y = 0, z = 0;
        for (Eigen::Index node = 0; node < mode_.coupled.flag_nodes; ++node) {
          const Displacement<double>& d = response[static_cast<std::size_t>(held + node)];
          const double zeta = (by * mode_.pair.q[mode_.coupled.zeta(node)]).real();
          y += zeta * d.y.row(0, j)[i];
          z += zeta * d.z.row(0, j)[i];
        }
        grid.y.row(plane, j)[i] += y;
        grid.z.row(plane, j)[i] += z;
      }
  }

  dns::NodeVectors<dim> positions(double t) const {
    dns::NodeVectors<dim> x = equilibrium(flag_, mode_.base.forces);
    for_each_free([&](int m, int j, Eigen::Index node) {
      x(dim - 1, flag_.mesh().index(m, j)) +=
          (factor(t, x_of(m)) * mode_.pair.q[mode_.coupled.zeta(node)]).real();
    });
    return x;
  }
  dns::NodeVectors<dim> velocities(double t) const {
    dns::NodeVectors<dim> v = dns::NodeVectors<dim>::Zero(dim, flag_.mesh().nodes());
    for_each_free([&](int m, int j, Eigen::Index node) {
      v(dim - 1, flag_.mesh().index(m, j)) =
          (factor(t, x_of(m)) * mode_.pair.q[mode_.coupled.zeta_t(node)]).real();
    });
    return v;
  }
  double x_of(int m) const { return flag_.mesh().is_two_d() ? 0 : flag_.mesh().x(m); }
  template <class Use>
  void for_each_free(const Use& use) const {
    for (int m = 0; m < flag_.mesh().stations(); ++m)
      for (int j = 1; j < flag_.mesh().chord_nodes(); ++j) use(m, j, j - 1);
  }

  const ModeOfCase& mode_;
  const dns::Fluid& fluid_;
  const dns::Flag<dim>& flag_;
  double k_x_, dt_;
};

// lambda of z = Re(a exp(lambda t)), from z every h: Prony's recursion z_{n+1} = 2 r cos z_n - r^2
// z_{n-1}, in least squares.
Complex exponent_of(const std::vector<double>& z, double h, std::size_t apart) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (std::size_t n = apart; n + apart < z.size(); ++n) {
    const double a = z[n], b = z[n - apart], c = z[n + apart];
    aa += a * a, ab += a * b, bb += b * b, ac += a * c, bc += b * c;
  }
  const double determinant = aa * bb - ab * ab;
  const double p = (ac * bb - bc * ab) / determinant, q = (bc * aa - ac * ab) / determinant;
  const Complex root = p / 2 + std::sqrt(Complex(p * p / 4 + q));
  return std::log(root) / (h * static_cast<double>(apart));
}

// The simulation's lambda with steps of dt over a time.
template <int dim>
Complex simulated(const test::CoupledCase& settings, const ModeOfCase& mode, double k_x, double dt,
                  double duration) {
  dns::Fluid fluid(mode.grid, dns::Span(settings.planes, settings.span), settings.fluid,
                   settings.tolerances);
  const dns::Flag<dim> flag(test::coupled_mesh(settings, mode.grid), settings.flag);
  dns::Coupling<dim> coupling(fluid, flag, Eigen::Matrix<double, dim, 1>::Zero(),
                              settings.coupling);
  const Start<dim> start(mode, fluid, flag, k_x, dt);
  dns::CoupledState<dim> state = start(coupling.start(equilibrium(flag, mode.base.forces), 0));
  std::vector<double> z;
  const auto steps = std::lround(duration / dt);
  for (long n = 0; n < steps; ++n) {
    coupling.advance(state, dt);
    z.push_back(state.flag.x(dim - 1, flag.mesh().chord_nodes() - 1));
  }
  const double eighth = std::numbers::pi / (4 * std::abs(mode.pair.lambda.imag()));
  return exponent_of(z, dt, static_cast<std::size_t>(std::lround(eighth / dt)));
}

// The error of the simulation's lambda with a step.
template <int dim>
double error_with(double dt, const test::CoupledCase& settings, Complex target) {
  const double k_x = dim == 2 ? 0 : 2 * std::numbers::pi / settings.span;
  const ModeOfCase mode(settings, k_x, dt, target);
  constexpr double duration = 1.2;
  return std::abs(simulated<dim>(settings, mode, k_x, dt, duration) - mode.pair.lambda) /
         std::abs(mode.pair.lambda);
}

// Of second order: a fourth and a little to spare.
constexpr double share_at_half_the_step = 0.31;

TEST(GlobalGrowth, OfTheSimulationInTwoDimensionsIsTheEigenvalueUpToTheSquareOfTheStep) {
  const Complex target(0.44, 2.66);
  const double coarse = error_with<2>(0.02, small_case(), target);
  const double fine = error_with<2>(0.01, small_case(), target);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_LT(fine, share_at_half_the_step * coarse);
}

TEST(GlobalGrowth, OfAWaveAlongTheSpanIsTheEigenvalueUpToTheSquareOfTheStep) {
  test::CoupledCase settings = small_case();
  settings.planes = 8;
  settings.span = 2;
  const Complex target(-0.1, 2.8);
  const double coarse = error_with<3>(0.02, settings, target);
  const double fine = error_with<3>(0.01, settings, target);
  EXPECT_LT(coarse, 2e-3);
  EXPECT_LT(fine, share_at_half_the_step * coarse);
}

// The shear that the cross-flow leaves in the flag is worth 5 % of lambda here.
TEST(GlobalGrowth, OfAWaveInACrossFlowIsTheEigenvalueUpToTheSquareOfTheStep) {
  test::CoupledCase settings = small_case();
  settings.planes = 8;
  settings.span = 2;
  settings.fluid.U = 0.5;
  const Complex target(-0.476, 2.66);
  const double coarse = error_with<3>(0.02, settings, target);
  const double fine = error_with<3>(0.01, settings, target);
  EXPECT_LT(coarse, 5e-3);
  EXPECT_LT(fine, share_at_half_the_step * coarse);
}

}  // namespace
}  // namespace pennon::modes::global

// Small parts of the fluid: points of the grid, prescribed motions, Krylov's method, stencils.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <random>

#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/fluid/vorticity.hpp"
#include "dns/grid/grid_point.hpp"
#include "dns/numerics/krylov.hpp"
#include "dns/run/prescribed_motion.hpp"
#include "dns/run/schedule.hpp"

namespace pennon::dns {
namespace {

using std::numbers::pi;

OGrid grid_of(int n_rho) {
  OGridSettings settings;
  settings.n_rho = n_rho;
  settings.n_theta = 2 * n_rho;
  settings.R = 4;
  settings.wall_spacing = 0.6 / n_rho;
  return OGrid(settings);
}

// A flag bent by z = 0.2 y sin(4 y).
Displacement<double> bent(const OGrid& grid) {
  Displacement<double> displacement(Extent{1, grid.n_rho(), grid.n_theta()});
  std::vector<double> y, z;
  for (int i = 0; i < grid.n_theta(); ++i) {
    const double chord = (1 + std::cos(grid.theta(i))) / 2;
    y.push_back(-0.1 * chord);
    z.push_back(0.2 * chord * std::sin(4 * chord));
  }
  EllipticGrid(grid).follow(0, y.data(), z.data(), displacement, 1e-9, 200);
  return displacement;
}

double largest_error_of_points(int n_rho) {
  const OGrid grid = grid_of(n_rho);
  const Displacement<double> displacement = bent(grid);
  Field<double> f(Extent{1, n_rho, 2 * n_rho});
  const auto function = [](double y, double z) { return std::sin(y) * std::cos(2 * z); };
  for (int j = 0; j < n_rho; ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const std::complex<double> rest = OGrid::place(grid.rho_centre(j), grid.theta_centre(i));
      const auto mean = [&](const Field<double>& d) {
        return 0.25 *
               (d.row(0, j)[i] + d.row(0, j)[i + 1] + d.row(0, j + 1)[i] + d.row(0, j + 1)[i + 1]);
      };
      f.row(0, j)[i] =
          function(rest.real() + mean(displacement.y), rest.imag() + mean(displacement.z));
    }
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  double error = 0;
  for (int k = 0; k < 500; ++k) {
    const double y = 0.5 + place(random), z = place(random);
    const std::optional<GridPoint> point = find_point(grid, displacement, 0, y, z);
    EXPECT_TRUE(point) << y << ' ' << z;
    if (point) error = std::max(error, std::abs(point->value(f, 0) - function(y, z)));
  }
  return error;
}

TEST(GridPoint, InterpolatesToSecondOrderOnABentGrid) {
  const double coarse = largest_error_of_points(24), fine = largest_error_of_points(48);
  EXPECT_LT(fine, 0.03);
  EXPECT_GT(std::log2(coarse / fine), 1.6) << "of random points the worst, not the same on both";
}

TEST(GridPoint, OutsideTheOuterBoundaryThereIsNone) {
  const OGrid grid = grid_of(24);
  EXPECT_FALSE(find_point(grid, bent(grid), 0, 5.0, 0.0));
  EXPECT_TRUE(find_point(grid, bent(grid), 0, 4.0, 0.5));
}

class Motion : public testing::Test {
 protected:
  WallShape at(double t) const {
    WallShape shape;
    shape.y.resize(static_cast<std::size_t>(grid_.n_theta()));
    shape.z.resize(shape.y.size());
    prescribed_motion(motion_, grid_, Span(1, 1))(t, shape);
    return shape;
  }
  OGrid grid_ = grid_of(12);
  MotionSettings motion_;
};

TEST_F(Motion, PitchKeepsDistancesFromTheAxis) {
  motion_.kind = MotionKind::pitch;
  motion_.amplitude = 0.7;
  motion_.axis = 0.25;
  const WallShape shape = at(0.2);
  for (int i = 0; i < grid_.n_theta(); ++i) {
    const double y = (1 + std::cos(grid_.theta(i))) / 2;
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(std::hypot(y + shape.y[k] - 0.25, shape.z[k]), std::abs(y - 0.25), 1e-15);
  }
  EXPECT_NEAR(std::atan2(shape.z[0], 0.75 + shape.y[0]), 0.7 * std::sin(0.4 * pi), 1e-15);
}

TEST_F(Motion, AWaveTravelsDownstream) {
  motion_.kind = MotionKind::wave;
  motion_.amplitude = 0.1;
  motion_.k_y = 3;
  motion_.frequency = 0.5;
  motion_.envelope = Envelope::uniform;
  // What is at y at t is at y + c dt later, c = omega/k_y.
  const double dt = 0.1, c = pi / 3;
  const WallShape early = at(1), late = at(1 + dt);
  for (int i = 0; i < grid_.n_theta(); ++i) {
    const double y = (1 + std::cos(grid_.theta(i))) / 2;
    EXPECT_NEAR(late.z[static_cast<std::size_t>(i)], 0.1 * std::sin(3 * (y - c * dt) - pi), 1e-15);
    EXPECT_NEAR(early.z[static_cast<std::size_t>(i)], 0.1 * std::sin(3 * y - pi), 1e-15);
  }
}

TEST_F(Motion, ARampStartsWithoutVelocityOrAcceleration) {
  motion_.kind = MotionKind::heave;
  motion_.amplitude = 1;
  motion_.frequency = 0;
  motion_.phase = pi / 2;
  motion_.ramp = 2;
  EXPECT_EQ(at(0).z[0], 0);
  EXPECT_LT(at(0.01).z[0], 1e-5);  // as t^3
  EXPECT_NEAR(at(1).z[0], 0.5, 1e-15);
  EXPECT_EQ(at(3).z[0], 1);
}

TEST(Krylov, SolvesToTheToleranceItIsGiven) {
  constexpr std::size_t n = 50;
  const auto multiply = [](const double* x, double* y) {
    for (std::size_t k = 0; k < n; ++k)
      y[k] = 3 * x[k] - (k > 0 ? 1.3 * x[k - 1] : 0) - (k + 1 < n ? 0.7 * x[k + 1] : 0);
  };
  const auto scale = [](const double* x, double* y) {
    for (std::size_t k = 0; k < n; ++k) y[k] = x[k] / 3;
  };
  Krylov krylov(n, {"test", 100, 30}, multiply, scale);
  std::vector<double> exact(n), b(n), x(n, 0.0);
  for (std::size_t k = 0; k < n; ++k) exact[k] = std::sin(static_cast<double>(k));
  multiply(exact.data(), b.data());
  for (const double tolerance : {1e-4, 1e-10}) {
    const KrylovSummary summary = krylov.solve(b.data(), x.data(), tolerance);
    EXPECT_TRUE(summary.converged);
    EXPECT_LE(summary.residual, tolerance);
    for (std::size_t k = 0; k < n; ++k) EXPECT_NEAR(x[k], exact[k], 30 * tolerance);
  }
  const KrylovSummary again = krylov.solve(b.data(), x.data(), 1e-8);
  EXPECT_EQ(again.iterations, 0) << "the guess is the solution";
}

TEST(Krylov, SaysThatItDidNotConverge) {
  const auto rotate = [](const double* x, double* y) {  // GMRES needs all n iterations
    for (std::size_t k = 0; k < 40; ++k) y[(k + 1) % 40] = x[k];
  };
  const auto copy = [](const double* x, double* y) { std::copy_n(x, 40, y); };
  Krylov krylov(40, {"test", 10, 30}, rotate, copy);
  std::vector<double> b(40, 0.0), x(40, 0.0);
  b[3] = 1;
  const KrylovSummary summary = krylov.solve(b.data(), x.data(), 1e-8);
  EXPECT_FALSE(summary.converged);
  EXPECT_EQ(summary.iterations, 10);
}

TEST(Krylov, PassesOnWhatItsOperatorsThrow) {
  const auto fail = [](const double*, double*) { throw std::runtime_error("no operator"); };
  const auto copy = [](const double* x, double* y) { std::copy_n(x, 4, y); };
  Krylov krylov(4, {"test", 10, 30}, fail, copy);
  std::vector<double> b(4, 1.0), x(4, 0.0);
  EXPECT_THROW(krylov.solve(b.data(), x.data(), 1e-8), std::runtime_error);
}

TEST(Schedule, FindsMultiplesOfAnIntervalDespiteRounding) {
  double t = 0;
  int found = 0;
  for (int step = 0; step < 1000; ++step) {
    const double before = t;
    t += 0.001;
    if (passes_multiple(0.1, before, t)) ++found;
  }
  EXPECT_EQ(found, 10);
  EXPECT_FALSE(passes_multiple(0, 0, 1));
}

// With complex numbers the stencils give their own derivative: what global modes will linearise.
TEST(Stencils, ComplexStepsGiveTheDerivativeOfConvectionAndFriction) {
  using Complex = std::complex<double>;
  const OGrid grid = grid_of(12);
  const Extent extent{1, grid.n_rho(), grid.n_theta()};
  const Displacement<double> displacement = bent(grid);
  Displacement<double> direction(extent);
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (Field<double>* field : {&direction.y, &direction.z}) {
    for (int j = 0; j <= grid.n_rho(); ++j)
      for (int i = 0; i < grid.n_theta(); ++i) field->row(0, j)[i] = 1e-4 * normal(random);
    field->wrap_theta(0, 0, grid.n_rho() + 1);
  }
  Field<double> f(extent), g(extent);
  for (Field<double>* field : {&f, &g})
    for (double& value : field->values()) value = normal(random);

  // f + step g convected by itself, and its integrated Laplacian, on the grid moved by step.
  const auto evaluate = [&](auto step) {
    using Scalar = decltype(step);
    Displacement<Scalar> moved(extent);
    Field<Scalar> sum(extent), convected(extent), laplacian(extent), C(extent);
    const auto add = [&](const Field<double>& a, const Field<double>& b, Field<Scalar>& result) {
      for (std::size_t k = 0; k < a.values().size(); ++k)
        result.values()[k] = a.values()[k] + step * b.values()[k];
    };
    add(displacement.y, direction.y, moved.y);
    add(displacement.z, direction.z, moved.z);
    add(f, g, sum);
    Metrics<Scalar> metrics(extent, false);
    update_metrics(grid, 0, moved, static_cast<const Displacement<Scalar>*>(nullptr), metrics);
    for (std::size_t k = 0; k < C.values().size(); ++k)
      C.values()[k] = sum.values()[k] * metrics.s_y.values()[k];
    convection(0, C, C, sum, upwinding::kawamura_kuwahara, convected);
    integrated_laplacian(metrics, 0, sum, static_cast<const Field<Scalar>*>(nullptr), true,
                         laplacian);
    std::vector<Scalar> all;
    for (int j = 0; j < extent.n_rho; ++j)
      for (int i = 0; i < extent.n_theta; ++i) {
        all.push_back(convected.row(0, j)[i]);
        all.push_back(laplacian.row(0, j)[i]);
      }
    return all;
  };
  constexpr double tiny = 1e-30, step = 1e-6;
  const std::vector<Complex> complex = evaluate(Complex(0, tiny));
  const std::vector<double> ahead = evaluate(step), behind = evaluate(-step);
  for (std::size_t k = 0; k < complex.size(); ++k) {
    const double derivative = complex[k].imag() / tiny;
    const double size = 1 + std::abs(derivative) + std::abs(complex[k].real());
    EXPECT_NEAR(derivative, (ahead[k] - behind[k]) / (2 * step), 1e-6 * size);
  }
}

// v = -z, w = y: omega_x = 2.
double error_of_vorticity(int n_rho) {
  const OGrid grid = grid_of(n_rho);
  Fluid fluid(grid, Span(1, 1), {100, 0}, {});
  const WallMotion still = [](double, WallShape& shape) {
    std::ranges::fill(shape.y, 0.0);
    std::ranges::fill(shape.z, 0.0);
  };
  FluidState state = fluid.impulsive_start(still, 0);
  for (int j = 0; j < grid.n_rho(); ++j)
    for (int i = 0; i < grid.n_theta(); ++i) {
      const auto [y, z] = fluid.centre(state, 0, j, i);
      state.u[0].row(0, j)[i] = -z;
      state.u[1].row(0, j)[i] = y;
    }
  const Vorticity omega = vorticity(fluid, state);
  EXPECT_TRUE(omega.in_plane.empty());
  double squares = 0, area = 0;
  for (int j = 2; j + 2 < grid.n_rho(); ++j)  // clear of the boundaries, which do not turn
    for (int i = 0; i < grid.n_theta(); ++i) {
      const double volume = fluid.metrics().volume.row(0, j)[i];
      squares += volume * std::pow(omega.x.row(0, j)[i] - 2, 2);
      area += volume;
    }
  return std::sqrt(squares / area);
}

// The disturbance q/r along the radius enters as it is, what turns about the origin and what flows
// along the span are turned round, and the stream stays; where fluid leaves, nothing is touched.
TEST(Inflow, IsNormalToTheOuterBoundaryAndWidensWithIt) {
  const OGrid grid({24, 48, 20, 0.05, 0});
  const Extent extent{1, 24, 48};
  Metrics<double> metrics(extent, false);
  update_metrics<double>(grid, 0, Displacement<double>(extent), nullptr, metrics);
  Field<double> v(extent), w(extent), u(extent);
  const auto radius = [&](int j, int i) {
    return OGrid::place(grid.rho_centre(j), grid.theta_centre(i)) - 0.5;
  };
  constexpr double source = 3, spin = 2, along_span = 0.7;
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i) {
      const std::complex<double> r = radius(j, i);
      v.row(0, j)[i] = 1 + (source * r.real() - spin * r.imag()) / std::norm(r);
      w.row(0, j)[i] = (source * r.imag() + spin * r.real()) / std::norm(r);
      u.row(0, j)[i] = along_span + 0.1;
    }
  std::vector<bool> is_inflow(48, true);
  is_inflow[7] = false;
  const double widening = std::exp(grid.rho_face_step(extent.n_rho));
  const Field<double> v_cells = v, w_cells = w;
  const Inflow<double> inflow{is_inflow, metrics.rho_faces, widening, v_cells, w_cells, 1};
  reflect_inflow(0, inflow, &metrics.rho_faces.area_y, 1, v);
  reflect_inflow(0, inflow, &metrics.rho_faces.area_z, 0, w);
  reflect_inflow<double>(0, inflow, nullptr, along_span, u);
  constexpr double ellipse = 2e-3;  // of 0.15: the boundary is not quite a circle
  for (int i = 0; i < extent.n_theta; ++i) {
    const std::complex<double> r = radius(extent.n_rho - 1, i), ghost = r * widening;
    if (i == 7) {
      EXPECT_EQ(v.row(0, extent.n_rho)[i], 0);
      continue;
    }
    EXPECT_NEAR(v.row(0, extent.n_rho)[i],
                1 + source * ghost.real() / std::norm(ghost) + spin * r.imag() / std::norm(r),
                ellipse);
    EXPECT_NEAR(w.row(0, extent.n_rho)[i],
                source * ghost.imag() / std::norm(ghost) - spin * r.real() / std::norm(r), ellipse);
    EXPECT_NEAR(u.row(0, extent.n_rho)[i], along_span - 0.1, 1e-12);
  }
}

TEST(Vorticity, OfARigidRotationIsTwiceItsRate) {
  const double coarse = error_of_vorticity(48), fine = error_of_vorticity(96);
  EXPECT_LT(fine, 0.02);
  EXPECT_GT(std::log2(coarse / fine), 1.8);
}

}  // namespace
}  // namespace pennon::dns

// What the discrete fluid satisfies to rounding, whatever the grid does.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "tests/support/fluids.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;
using std::numbers::pi;

// A wave of slope to 1 that also moves in its plane, and changes along the span of length 1.
PointMotion wave(double k_x) {
  return [k_x](double t, double x, double y) -> std::array<double, 2> {
    return {-0.05 * y * y * std::sin(t),
            0.1 * y * std::sin(5 * y - 4 * t) * (1 + 0.5 * std::cos(k_x * x))};
  };
}

FluidCase small_case(int planes) {
  FluidCase settings;
  settings.grid = {24, 48, 4, 0.03, 0.2};
  settings.parameters = {100, 0.7};
  settings.planes = planes;
  settings.tolerances = {1e-11, 1e-12, 1e-5, 20};
  return settings;
}

// Largest departures from the stream after steps on a moving grid whose wall does not disturb it:
// along x, and of the other two.
std::array<double, 2> departures_from_the_stream(int planes) {
  FluidCase settings = small_case(planes);
  // Planes whose grids stop short of their equilibrium by different numbers of passes are rough
  // along the span by as much.
  settings.tolerances.grid = 1e-10;
  settings.tolerances.most_grid_passes = 100;
  FluidRun run(settings, wave(planes > 1 ? 2 * pi : 0));
  run.fluid().manufacture({{}, [&run](double, double, double, double) {
                             return std::array<double, 3>{run.fluid().parameters().U, 1, 0};
                           }});
  run.fill_with_stream();
  run.run_to(0.2, 0.01);
  std::array<double, 2> largest{};
  run.at_cells([&](int plane, int j, int i) {
    const auto& u = run.state().u;
    const double U = run.fluid().parameters().U;
    largest[0] = std::max(largest[0], std::abs(u[2].row(plane, j)[i] - U));
    largest[1] = std::max(
        {largest[1], std::abs(u[0].row(plane, j)[i] - 1), std::abs(u[1].row(plane, j)[i])});
  });
  return largest;
}

constexpr double rounding = 1e-11;  // of numbers of order 1 after 20 steps, over cells of 1e-3

// The areas of a cell sum to zero, so that a uniform stream is free of divergence.
TEST(FreeStream, StaysFreeOnAMovingGridInTwoDimensions) {
  const auto [along_span, in_plane] = departures_from_the_stream(1);
  EXPECT_LT(along_span, rounding);
  EXPECT_LT(in_plane, rounding);
}

// Along x the volume of a cell, a product, is differentiated by its Fourier coefficients: it is
// the sum of the areas but for what they alias.
TEST(FreeStream, StaysFreeOnAGridThatChangesAlongTheSpanButForAliases) {
  // Four planes see a cosine and its square wrongly; each doubling gains more than the last.
  constexpr std::array<int, 3> planes = {4, 8, 16};
  constexpr std::array<double, 3> most = {1e-3, 1e-5, 1e-9};
  for (std::size_t n = 0; n < planes.size(); ++n) {
    const auto [along_span, in_plane] = departures_from_the_stream(planes[n]);
    EXPECT_LT(along_span, most[n]) << planes[n];
    EXPECT_LT(in_plane, most[n]) << planes[n];
  }
}

// Numbers without any order.
Field<double> noise(const Extent& extent, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> number(-1, 1);
  Field<double> f(extent);
  for (double& value : f.values()) value = number(generator);
  return f;
}

struct Deformed {  // a fluid about a bent flag, its metrics at hand
  FluidRun run;
  explicit Deformed(double t = 0.3) : run(small_case(1), wave(0)) { run.run_to(t, 0.05); }
  const Metrics<double>& metrics() { return run.fluid().metrics(); }
  const Extent& extent() { return run.fluid().extent(); }
};

TEST(Stencils, TheDivergencesOfAllCellsSumToTheFluxThroughTheBoundary) {
  Deformed bent;
  const Extent& extent = bent.extent();
  Field<double> across_rho = noise(extent, 1), across_theta = noise(extent, 2), divergence(extent);
  double boundary = 0, sum = 0;
  for (int j = 0; j < extent.n_rho; ++j)
    across_theta.row(0, j)[extent.n_theta] = across_theta.row(0, j)[0];
  add_divergence(0, across_rho, across_theta, divergence);
  for (int i = 0; i < extent.n_theta; ++i)
    boundary += across_rho.row(0, extent.n_rho)[i] - across_rho.row(0, 0)[i];
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i) sum += divergence.row(0, j)[i];
  EXPECT_NEAR(sum, boundary, rounding);
}

// integrated_laplacian() is the divergence of gradient_flux(), both written out for speed.
TEST(Stencils, TheLaplacianIsTheDivergenceOfTheGradientsFluxes) {
  Deformed bent;
  const Extent& extent = bent.extent();
  Field<double> f = noise(extent, 3), across_rho(extent), across_theta(extent), divergence(extent),
                direct(extent);
  f.wrap_theta(0, -2, extent.n_rho + 2);
  gradient_flux<double>(bent.metrics(), 0, f, nullptr, across_rho, across_theta);
  add_divergence(0, across_rho, across_theta, divergence);
  integrated_laplacian<double>(bent.metrics(), 0, f, nullptr, true, direct);
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i)
      ASSERT_NEAR(divergence.row(0, j)[i], direct.row(0, j)[i], 1e-9) << j << ' ' << i;
}

// The cells' areas close, and add up to the area between the flag and the outer boundary.
TEST(Metrics, TheAreasOfACellSumToZero) {
  Deformed bent;
  const Extent& extent = bent.extent();
  for (int j = 0; j < extent.n_rho; ++j)
    for (int i = 0; i < extent.n_theta; ++i) {
      const auto sum = [&](const Field<double>& rho, const Field<double>& theta) {
        return rho.row(0, j + 1)[i] - rho.row(0, j)[i] + theta.row(0, j)[i + 1] -
               theta.row(0, j)[i];
      };
      const Metrics<double>& metrics = bent.metrics();
      ASSERT_NEAR(sum(metrics.rho_faces.area_y, metrics.theta_faces.area_y), 0, 1e-13);
      ASSERT_NEAR(sum(metrics.rho_faces.area_z, metrics.theta_faces.area_z), 0, 1e-13);
    }
}

// Root mean square error of the gradient of 2 y - 3 z over the area within 1.5 L of mid-chord.
double error_of_a_linear_gradient(int n_rho) {
  FluidCase settings = small_case(1);
  settings.grid.n_rho = n_rho;
  settings.grid.n_theta = 2 * n_rho;
  settings.grid.wall_spacing = 0.72 / n_rho;
  settings.tolerances.grid = 1e-9;
  settings.tolerances.most_grid_passes = 200;
  FluidRun run(settings, [](double, double, double y) -> std::array<double, 2> {
    return {0, 0.1 * y * std::sin(5 * y)};
  });
  const Extent& extent = run.fluid().extent();
  Field<double> f(extent), f_y(extent), f_z(extent);
  run.at_cells([&](int plane, int j, int i) {
    const auto [y, z] = run.fluid().centre(run.state(), plane, j, i);
    f.row(plane, j)[i] = 2 * y - 3 * z;
  });
  f.wrap_theta(0, 0, n_rho);
  gradient<double>(run.fluid().metrics(), 0, f, nullptr, {nullptr, &f_y, &f_z});
  double square = 0, area = 0;
  run.at_cells([&](int plane, int j, int i) {
    if (j == 0 || j == n_rho - 1) return;
    const auto [y, z] = run.fluid().centre(run.state(), plane, j, i);
    if (std::hypot(y - 0.5, z) > 1.5) return;
    const double volume = run.fluid().metrics().volume.row(plane, j)[i];
    square +=
        volume * (std::pow(f_y.row(plane, j)[i] - 2, 2) + std::pow(f_z.row(plane, j)[i] + 3, 2));
    area += volume;
  });
  return std::sqrt(square / area);
}

// The derivatives of the conformal grid are exact and the differences are not: a linear field is
// not exact either, but of second order in the mean. (At the two edges, where the cells' sides go
// to zero like their distance, it is of first order.)
TEST(Stencils, TheGradientOfALinearFieldIsOfSecondOrder) {
  const double coarse = error_of_a_linear_gradient(24), fine = error_of_a_linear_gradient(48);
  EXPECT_GT(std::log2(coarse / fine), 1.7);
}

// At rest the preconditioner is the inverse of the operator itself.
TEST(PressureSolver, NeedsOneIterationAtRest) {
  for (const int planes : {1, 8}) {
    FluidCase settings = small_case(planes);
    settings.tolerances = {};
    FluidRun run(settings);
    std::mt19937 generator(4);
    std::uniform_real_distribution<double> number(-0.1, 0.1);
    for (Field<double>& u : run.state().u)
      for (double& value : u.values()) value += number(generator);
    run.run_to(0.1, 0.01);
    EXPECT_LE(run.most_pressure_iterations(), 1) << planes;
  }
}

TEST(PressureSolver, NeedsFewIterationsInMotion) {
  for (const int planes : {1, 8}) {
    FluidCase settings = small_case(planes);
    settings.tolerances = {};
    FluidRun run(settings, wave(planes > 1 ? 2 * pi : 0));
    run.run_to(1, 0.01);
    EXPECT_LE(run.most_pressure_iterations(), 12) << planes;  // 9 in two dimensions, 8 in three
  }
}

}  // namespace
}  // namespace pennon::dns

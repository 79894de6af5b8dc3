// The fluid's budgets of kinetic energy and momentum: what the flag does, what friction takes and
// what leaves through a closed line add up to what the fluid gains.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "tests/support/fluids.hpp"
#include "tests/support/slope.hpp"

namespace pennon::dns {
namespace {

using namespace pennon::test;

struct Budget {  // of the fluid between the flag and a line rho = const; disturbances from (1, 0)
  double energy = 0, momentum_y = 0, momentum_z = 0;    // what the fluid holds
  double power_in = 0, force_in_y = 0, force_in_z = 0;  // what enters per unit of time
};

// What the fluid within the first `rows` of cells holds and gains, for one plane.
Budget budget_within(FluidRun& run, int rows) {
  const Fluid& fluid = run.fluid();
  const FluidState& state = run.state();
  const Extent& extent = fluid.extent();
  const Metrics<double>& metrics = fluid.metrics();
  const double nu = 1 / fluid.parameters().Re;
  Field<double> v = state.u[0], w = state.u[1], p = state.p;
  fluid.extend_velocity(along_y, v);
  fluid.extend_velocity(along_z, w);
  fluid.extend_pressure(p);
  Field<double> v_y(extent), v_z(extent), w_y(extent), w_z(extent);
  gradient<double>(metrics, 0, v, nullptr, {nullptr, &v_y, &v_z});
  gradient<double>(metrics, 0, w, nullptr, {nullptr, &w_y, &w_z});
  Field<double> v_flux(extent), w_flux(extent), unused(extent);
  gradient_flux<double>(metrics, 0, v, nullptr, v_flux, unused);
  gradient_flux<double>(metrics, 0, w, nullptr, w_flux, unused);
  Budget budget;
  const auto square = [](double f) { return f * f; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < extent.n_theta; ++i) {
      const double volume = metrics.volume.row(0, j)[i];
      const double v_here = v.row(0, j)[i] - 1, w_here = w.row(0, j)[i];
      budget.energy += volume * (square(v_here) + square(w_here)) / 2;
      budget.momentum_y += volume * v_here;
      budget.momentum_z += volume * w_here;
      budget.power_in -= nu * volume *
                         (square(v_y.row(0, j)[i]) + square(v_z.row(0, j)[i]) +
                          square(w_y.row(0, j)[i]) + square(w_z.row(0, j)[i]));
    }
  const WallTraction traction = run.traction();
  for (int i = 0; i < extent.n_theta; ++i) {
    const auto face = static_cast<std::size_t>(i);
    budget.force_in_y -= traction.force[1][face];
    budget.force_in_z -= traction.force[2][face];
    budget.power_in -= traction.force[1][face] * (fluid.wall_velocity()[0][face] - 1) +
                       traction.force[2][face] * fluid.wall_velocity()[1][face];
    const auto on_line = [&](const Field<double>& f) {
      return (f.row(0, rows - 1)[i] + f.row(0, rows)[i]) / 2;
    };
    const double A_y = metrics.rho_faces.area_y.row(0, rows)[i],
                 A_z = metrics.rho_faces.area_z.row(0, rows)[i];
    const double v_line = on_line(v) - 1, w_line = on_line(w), p_line = on_line(p);
    const double through = fluid.flux_across_rho().row(0, rows)[i] -
                           A_y * on_line(fluid.grid_velocity_y()) -
                           A_z * on_line(fluid.grid_velocity_z());
    const double friction_y = nu * v_flux.row(0, rows)[i], friction_z = nu * w_flux.row(0, rows)[i];
    budget.force_in_y += friction_y - p_line * A_y - through * v_line;
    budget.force_in_z += friction_z - p_line * A_z - through * w_line;
    budget.power_in += friction_y * v_line + friction_z * w_line -
                       p_line * (A_y * v_line + A_z * w_line) -
                       through * (square(v_line) + square(w_line)) / 2;
  }
  return budget;
}

struct Residuals {                  // root mean squares over the second half of the run
  double energy = 0, momentum = 0;  // within a line about half way out
  double whole_energy = 0, whole_y = 0, whole_z = 0;  // by fluid_budget(), of the whole domain
};

constexpr double Re = 100;

// A flag that begins to flap in a stream that started with it.
Residuals residuals_of(int n_rho, double R) {
  FluidCase settings;
  settings.grid = {n_rho, 2 * n_rho, R, 0.8 / n_rho, 0};
  settings.parameters = {Re, 0};
  // So that what is seen is the discretisation: the grid's share enters through d/dt.
  settings.tolerances = {1e-8, 1e-9, 1e-7, 40};
  FluidRun run(settings, [](double t, double, double y) -> std::array<double, 2> {
    const double begun = t * t * t / (0.03 + t * t * t);
    return {-0.05 * y * y * std::sin(t) * begun, 0.1 * y * std::sin(3 * y - 4 * t) * begun};
  });
  const double dt = 0.24 / n_rho;
  constexpr double t_end = 1.5;
  const int steps = static_cast<int>(std::lround(t_end / dt)), half = steps / 2;
  const int line = 5 * n_rho / 6;
  Slope energy, momentum_y, momentum_z, whole_energy, whole_y, whole_z;
  Residuals sum;
  for (int n = 1; n <= steps; ++n) {
    run.step(dt);
    if (n < half - 2) continue;
    const Budget within = budget_within(run, line);
    const FluidBudget whole = run.budget();
    energy.add(within.energy);
    momentum_y.add(within.momentum_y);
    momentum_z.add(within.momentum_z);
    whole_energy.add(whole.kinetic_energy);
    whole_y.add(whole.momentum[1]);
    whole_z.add(whole.momentum[2]);
    if (n < half) continue;
    const Vector3 force = run.force();
    const double share = 1 / (steps - half + 1.0);
    sum.energy += share * std::pow(energy.by_time(dt) - within.power_in, 2);
    sum.momentum += share * (std::pow(momentum_y.by_time(dt) - within.force_in_y, 2) +
                             std::pow(momentum_z.by_time(dt) - within.force_in_z, 2));
    sum.whole_energy += share * std::pow(whole_energy.by_time(dt) - whole.wall_power +
                                             whole.dissipation - whole.outer_power,
                                         2);
    sum.whole_y += share * std::pow(whole_y.by_time(dt) + force[1] - whole.outer_force[1], 2);
    sum.whole_z += share * std::pow(whole_z.by_time(dt) + force[2] - whole.outer_force[2], 2);
  }
  return {std::sqrt(sum.energy), std::sqrt(sum.momentum), std::sqrt(sum.whole_energy),
          std::sqrt(sum.whole_y), std::sqrt(sum.whole_z)};
}

double order(double coarse, double fine, double ratio) {
  return std::log(coarse / fine) / std::log(ratio);
}

// The measured orders are 1.5 from 24 to 36 and 1.9 from 36 to 54 (2.2 from 48 to 96).
TEST(FluidBudgets, CloseWithSecondOrderAboutAFlappingFlag) {
  const Residuals coarse = residuals_of(24, 4), middle = residuals_of(36, 4),
                  fine = residuals_of(54, 4);
  EXPECT_GT(order(coarse.energy, middle.energy, 1.5), 1.4);
  EXPECT_GT(order(coarse.momentum, middle.momentum, 1.5), 1.4);
  EXPECT_GT(order(middle.energy, fine.energy, 1.5), 1.8);
  EXPECT_GT(order(middle.momentum, fine.momentum, 1.5), 1.8);
  // Both are shares of a power and a force of 0.2.
  EXPECT_LT(fine.energy, 0.0025);
  EXPECT_LT(fine.momentum, 0.005);
  // Over the outer boundary: 1.8 of energy, 2.5 of momentum along y and z.
  EXPECT_GT(order(middle.whole_energy, fine.whole_energy, 1.5), 1.8);
  EXPECT_GT(order(middle.whole_y, fine.whole_y, 1.5), 2);
  EXPECT_GT(order(middle.whole_z, fine.whole_z, 1.5), 2);
  EXPECT_NEAR(fine.whole_energy / fine.energy, 1, 0.03) << "the outer boundary's own share";
  EXPECT_LT(fine.whole_y, 0.001);
  EXPECT_LT(fine.whole_z, 0.001);
}

// The outer boundary so near that the flag is felt there: measured orders 2.0, 1.9 and 1.7. Where
// the stream entered at its own velocity without pressure, they were 1.4, 1.5 and 1.6.
TEST(FluidBudgets, CloseOverANearOuterBoundary) {
  const Residuals coarse = residuals_of(54, 2), fine = residuals_of(81, 2);
  EXPECT_GT(order(coarse.whole_energy, fine.whole_energy, 1.5), 1.9);
  EXPECT_GT(order(coarse.whole_y, fine.whole_y, 1.5), 1.8);
  EXPECT_GT(order(coarse.whole_z, fine.whole_z, 1.5), 1.6);
}

// What enters loses energy at the boundary, -u_n v'_n^2/2 for each area, and brings no momentum.
TEST(FluidBudgets, GetNoEnergyAndNoMomentumFromWhatEnters) {
  FluidCase settings;
  settings.grid = {32, 64, 1, 0.03, 0};
  settings.parameters = {Re, 0};
  FluidRun run(settings, [](double t, double, double y) -> std::array<double, 2> {
    return {0, 0.2 * y * std::sin(3 * t)};
  });
  run.run_to(0.5, 0.005);
  const Fluid& fluid = run.fluid();
  const int n = fluid.extent().n_rho;
  double greatest = 0;
  for (int i = 0; i < fluid.extent().n_theta; ++i) {
    const double A_y = fluid.metrics().rho_faces.area_y.row(0, n)[i],
                 A_z = fluid.metrics().rho_faces.area_z.row(0, n)[i];
    const double area = std::hypot(A_y, A_z);
    const double u_n = fluid.flux_across_rho().row(0, n)[i] / area, disturbance = u_n - A_y / area;
    const double p = fluid.outer_pressure()[static_cast<std::size_t>(i)];
    // The step's last pressure is not in the predicted velocity, that p is taken from.
    EXPECT_NEAR(p, u_n < 0 ? -u_n * disturbance : 0.0, 0.002) << i;
    greatest = std::max(greatest, std::abs(p));
    if (u_n < 0) {  // what is lost, outward
      EXPECT_GT(u_n * disturbance * disturbance / 2 + p * disturbance, -1e-5) << i;
    }
  }
  EXPECT_GT(greatest, 0.02) << "too little enters for this test";
}

// What momentum the plate takes from the stream, the whole domain misses; a viscous force through
// the outer boundary, as there was one that grew as the cells there shrank, would show: it left
// 0.0024 at 96 x 192 and R = 4.
TEST(FluidBudgets, OfMomentumCloseForThePlateAtRest) {
  FluidCase settings;
  settings.grid = {96, 192, 4, 0.8 / 96, 0};
  settings.parameters = {Re, 0.7};
  FluidRun run(settings);
  constexpr double dt = 0.005;
  run.run_to(1.49, dt);
  std::array<Slope, 2> momentum;  // along x and y
  for (int n = 0; n < 3; ++n) {
    for (std::size_t axis = 0; axis < 2; ++axis) momentum[axis].add(run.budget().momentum[axis]);
    if (n < 2) run.step(dt);
  }
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double force = run.force()[axis];
    EXPECT_NEAR(momentum[axis].by_time(dt), -force + run.budget().outer_force[axis], 0.006 * force)
        << axis;
  }
}

}  // namespace
}  // namespace pennon::dns

#include "dns/fluid/fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"
#include "common/smooth_rise.hpp"
#include "common/stop_watch.hpp"
#include "dns/fluid/equations/ghosts.hpp"
#include "dns/grid/packing.hpp"

namespace pennon::dns {
namespace {

// The components of FluidState::u.
constexpr int along_y = 0, along_z = 1, along_x = 2;
// Which of x, y, z each of them is.
constexpr std::array<std::size_t, 3> axis_of = {1, 2, 0};

// sum = a f + b g, ghosts too.
void combine(double a, const Field<double>& f, double b, const Field<double>& g,
             Field<double>& sum) {
  const double *from = f.values().data(), *other = g.values().data();
  double* to = sum.values().data();
  for (std::size_t k = 0; k < sum.values().size(); ++k) to[k] = a * from[k] + b * other[k];
}

}  // namespace

Fluid::Fluid(const OGrid& grid, Span span, const FluidParameters& parameters,
             const FluidTolerances& tolerances, const Upwinding& upwinding)
    : grid_(grid),
      span_(std::move(span)),
      parameters_(parameters),
      tolerances_(tolerances),
      upwinding_(upwinding),
      extent_{span_.local_planes(), grid.n_rho(), grid.n_theta()},
      components_(span_.has_span() || parameters.U != 0 ? 3 : 2),
      elliptic_(grid),
      metrics_(extent_, span_.has_span()),
      krylov_space_(std::make_shared<KrylovSpace>(2 * extent_.cells())),
      pressure_(
          extent_.cells(), {"pressure", 200, 30},
          [this](const double* in, double* out) { pressure_operator(in, out); },
          [this](const double* in, double* out) { invert_flat_pressure(in, out); }, krylov_space_),
      velocity_in_plane_(
          2 * extent_.cells(), {"velocity", 200, 10},
          [this](const double* in, double* out) {
            velocity_operator({0, 2}, in, out);
          },
          [this](const double* in, double* out) { lines_.invert(2, in, out); }, krylov_space_),
      velocity_along_span_(
          components_ > 2 ? extent_.cells() : 0, {"velocity", 200, 10},
          [this](const double* in, double* out) {
            velocity_operator({2, 3}, in, out);
          },
          [this](const double* in, double* out) { lines_.invert(1, in, out); }, krylov_space_),
      grid_velocity_y_(extent_),
      grid_velocity_z_(extent_),
      flux_rho_(extent_),
      flux_theta_(extent_),
      balance_(Extent{1, grid.n_rho(), grid.n_theta()}),
      carried_(balance_.extent()),
      C_s_(flux_rho_),
      C_t_(flux_theta_),
      lines_(extent_) {
  for (int plane = 0; plane < extent_.planes; ++plane)
    if (const int waves = span_.waves(plane); !span_.is_dropped(plane) && !flat_.contains(waves))
      flat_.try_emplace(waves, grid, Span::wavenumber(waves, span_.planes(), span_.length()));
  no_velocity_.resize(static_cast<std::size_t>(extent_.n_theta));
  const std::size_t wall =
      static_cast<std::size_t>(extent_.planes) * static_cast<std::size_t>(extent_.n_theta);
  wall_ = {std::vector<double>(wall), std::vector<double>(wall)};
  outer_pressure_.resize(wall);
  wall_velocity_.assign(static_cast<std::size_t>(components_), std::vector<double>(wall));
  guess_.assign(static_cast<std::size_t>(components_), Field<double>(extent_));
  change_.assign(2, Field<double>(extent_));
  change_xi_.assign(2, span_.has_span() ? Field<double>(extent_) : Field<double>());
  for (std::vector<double>* vector : {&right_, &solution_}) vector->resize(2 * extent_.cells());
}

double Fluid::stream(int component) const {
  return smooth_rise(step_.t, parameters_.ramp) * risen_stream(component);
}

double Fluid::risen_stream(int component) const {
  if (component == along_x) return parameters_.U;
  return component == along_y ? 1.0 : 0.0;
}

void Fluid::fail(double t, const std::string& what) const {
  throw SolverError(fmt::format("at t = {:.6g}: {}", t, what));
}

// --- The step
// -------------------------------------------------------------------------------------

void Fluid::update_all_metrics(const Displacement<double>& displacement) {
  Displacement<double> slope(Extent{0, 0, 0});
  if (span_.has_span()) {
    std::swap(slope.y, change_xi_[0]);
    std::swap(slope.z, change_xi_[1]);
    span_.differentiate(displacement.y, slope.y);
    span_.differentiate(displacement.z, slope.z);
  }
  for (int plane = 0; plane < extent_.planes; ++plane)
    update_metrics(grid_, plane, displacement, span_.has_span() ? &slope : nullptr, metrics_);
  if (span_.has_span()) {
    std::swap(slope.y, change_xi_[0]);
    std::swap(slope.z, change_xi_[1]);
  }
}

// The corners at the end of the step, from those of the last two.
void Fluid::move_grid(FluidState& state, const WallShape& wall) {
  const BackwardDifference& D = step_.D;
  std::rotate(state.grid.begin(), state.grid.end() - 1, state.grid.end());
  Displacement<double>&next = state.grid[0], &last = state.grid[1], &before = state.grid[2];
  combine(D.guess_last, last.y, D.guess_before, before.y, next.y);
  combine(D.guess_last, last.z, D.guess_before, before.z, next.z);
  std::array<double, 4> fold{};  // whether there is one, and its x, y, z
  for (int plane = 0; plane < extent_.planes; ++plane) {
    const std::size_t first = extent_.wall_face(plane, 0);
    const EllipticGridSummary found =
        elliptic_.follow(plane, wall.y.data() + first, wall.z.data() + first, next,
                         tolerances_.grid, tolerances_.most_grid_passes);
    step_.summary.grid_passes = std::max(step_.summary.grid_passes, found.passes);
    step_.summary.least_area = std::min(step_.summary.least_area, found.least_area);
    step_.summary.largest_wall_area =
        std::max(step_.summary.largest_wall_area, elliptic_.largest_wall_area(plane, next));
    if (!(found.least_area > 0)) fold = {1, span_.x(plane), found.worst_y, found.worst_z};
  }
  const std::vector<double> folds = ranks::gather_all(fold);
  for (std::size_t k = 0; k < folds.size(); k += fold.size())
    if (folds[k] > 0)
      fail(step_.t,
           fmt::format("the grid folds at ({:.4g}, {:.4g}, {:.4g}): the flag bends too sharply "
                       "for dns.n_theta = {}, or moves too far in a step of dns.dt",
                       folds[k + 1], folds[k + 2], folds[k + 3], extent_.n_theta));
}

// v_g, and the wall's velocity with it.
void Fluid::find_grid_velocity(const FluidState& state) {
  const int n_theta = extent_.n_theta;
  Field<double>& corners = change_[0];
  const auto velocity_of = [&](Field<double> Displacement<double>::*direction,
                               Field<double>& at_cells, std::vector<double>& at_wall) {
    const Field<double>&d0 = state.grid[0].*direction, &d1 = state.grid[1].*direction,
          &d2 = state.grid[2].*direction;
    for (int plane = 0; plane < extent_.planes; ++plane) {
      for (int j = 0; j <= extent_.n_rho; ++j) {
        const double *a = d0.row(plane, j), *b = d1.row(plane, j), *c = d2.row(plane, j);
        double* corner = corners.row(plane, j);
        for (int i = 0; i <= n_theta; ++i) corner[i] = step_.D.derivative(a[i], b[i], c[i]);
      }
      for (int j = 0; j < extent_.n_rho; ++j) {
        const double *below = corners.row(plane, j), *above = corners.row(plane, j + 1);
        double* cell = at_cells.row(plane, j);
        for (int i = 0; i < n_theta; ++i)
          cell[i] = 0.25 * (below[i] + below[i + 1] + above[i] + above[i + 1]);
      }
      const double* corner = corners.row(plane, 0);
      for (int i = 0; i < n_theta; ++i)
        at_wall[extent_.wall_face(plane, i)] = 0.5 * (corner[i] + corner[i + 1]);
    }
  };
  velocity_of(&Displacement<double>::y, grid_velocity_y_, wall_velocity_[along_y]);
  velocity_of(&Displacement<double>::z, grid_velocity_z_, wall_velocity_[along_z]);
  if (!manufactured_.wall_velocity) return;
  for (int plane = 0; plane < extent_.planes; ++plane)
    for (int i = 0; i < n_theta; ++i) {
      const std::complex<double> rest = OGrid::place(0, grid_.theta_centre(i));
      const double *y = state.grid[0].y.row(plane, 0) + i, *z = state.grid[0].z.row(plane, 0) + i;
      const std::array<double, 3> velocity =
          manufactured_.wall_velocity(step_.t, span_.x(plane), rest.real() + 0.5 * (y[0] + y[1]),
                                      rest.imag() + 0.5 * (z[0] + z[1]));
      for (std::size_t c = 0; c < wall_velocity_.size(); ++c)
        wall_velocity_[c][extent_.wall_face(plane, i)] = velocity[axis_of[c]];
    }
}

std::array<double, 2> Fluid::centre(const FluidState& state, int plane, int j, int i) const {
  const std::complex<double> rest = OGrid::place(grid_.rho_centre(j), grid_.theta_centre(i));
  const auto mean = [&](const Field<double>& d) {
    const double *below = d.row(plane, j) + i, *above = d.row(plane, j + 1) + i;
    return 0.25 * (below[0] + below[1] + above[0] + above[1]);
  };
  return {rest.real() + mean(state.grid[0].y), rest.imag() + mean(state.grid[0].z)};
}

void Fluid::add_force(const FluidState& state, std::size_t component, double* right) {
  for_each_row(extent_, [&](int plane, int j) {
    for (int i = 0; i < extent_.n_theta; ++i) {
      const auto [y, z] = centre(state, plane, j, i);
      *right++ += metrics_.volume.row(plane, j)[i] *
                  manufactured_.force(step_.t, span_.x(plane), y, z)[axis_of[component]];
    }
  });
}

// The velocity without the new pressure: convection extrapolated, viscosity implicit.
void Fluid::predict(FluidState& state) {
  is_inflow_ = state.is_inflow;
  for (std::size_t c = 0; c < guess_.size(); ++c)
    combine(step_.D.guess_last, state.u[c], step_.D.guess_before, state.u_last[c], guess_[c]);
  find_convection();
  lines_.prepare(metrics_, C_s_, C_t_, step_.D.next, 1 / parameters_.Re);
  find_outer_pressure(state.u);
  extend_pressure(state.p);
  const std::size_t cells = extent_.cells();
  const auto solve = [&](Krylov& krylov, const Components& components) {
    const auto [first, end] = components;
    for (std::size_t c = first; c < end; ++c) {
      double* right = right_.data() + (c - first) * cells;
      subtract_equation(state, c, right);
      if (manufactured_.force) add_force(state, c, right);
      pack(state.u_change[c], solution_.data() + (c - first) * cells);
    }
    const KrylovSummary solved =
        krylov.solve(right_.data(), solution_.data(), tolerances_.velocity);
    if (!solved.converged)
      fail(state.t, fmt::format("the viscous solver stopped after {} iterations with an error of "
                                "{:.3g}; a smaller dns.dt or, where the boundary layer is "
                                "thinner than a cell, a smaller dns.wall_spacing may help",
                                solved.iterations, solved.residual));
    step_.summary.velocity_iterations =
        std::max(step_.summary.velocity_iterations, solved.iterations);
    for (std::size_t c = first; c < end; ++c)
      unpack(solution_.data() + (c - first) * cells, state.u_change[c]);
  };
  // Apart, so that a cross-flow changes nothing across it, to the last bit.
  solve(velocity_in_plane_, {0, 2});
  if (components_ > 2) solve(velocity_along_span_, {2, 3});
  for (std::size_t c = 0; c < guess_.size(); ++c)  // only now: the guess carries all of them
    combine(1, guess_[c], 1, state.u_change[c], guess_[c]);
}

// What carries the velocity, v - v_g of the guess, in cells along s and t.
void Fluid::find_convection() {
  const bool has_span = span_.has_span();
  for_each_row(extent_, [&](int plane, int j) {
    double *C_s = C_s_.row(plane, j), *C_t = C_t_.row(plane, j);
    convecting_velocity(metrics_, plane, j, has_span ? &guess_[along_x] : nullptr, guess_[along_y],
                        guess_[along_z], grid_velocity_y_, grid_velocity_z_, C_s, C_t);
    double& CFL = step_.summary.CFL;
    for (int i = 0; i < extent_.n_theta; ++i)
      CFL = std::max(CFL, (std::abs(C_s[i]) + std::abs(C_t[i])) * step_.dt);
  });
  if (has_span) carry_along_span();
}

// Whether the change from the guess must be carried along the span: where neither
// friction nor convection along x goes far in a step, they may act on the guess alone. That is of
// second order too, and spares the solver its transforms.
void Fluid::carry_along_span() {
  double fastest = 0;
  for_each_row(extent_, [&](int plane, int j) {
    for (int i = 0; i < extent_.n_theta; ++i)
      fastest = std::max(fastest, std::abs(guess_[along_x].row(plane, j)[i]));
  });
  const double k = std::numbers::pi * span_.planes() / span_.length(), dt = 1 / step_.D.next;
  constexpr double little_friction = 0.1, little_convection = 0.05;  // of a mode in a step
  change_varies_ = k * k * dt / parameters_.Re > little_friction ||
                   k * dt * ranks::largest(fastest) > little_convection;
}

// Without a span the pressure acts in the plane alone.
bool Fluid::has_pressure_gradient(std::size_t component) const {
  return component != along_x || span_.has_span();
}

// The gradient's component, of the pressure with its ghosts. Works in change_xi_[1].
void Fluid::find_pressure_gradient(const FluidState& state, std::size_t component,
                                   Field<double>& gradient) {
  const std::array<const Field<double>*, 3> s = {&metrics_.s_y, &metrics_.s_z, &metrics_.s_x},
                                            t = {&metrics_.t_y, &metrics_.t_z, &metrics_.t_x};
  for (int plane = 0; plane < extent_.planes; ++plane)
    gradient_component(plane, *s[component], *t[component], state.p, gradient);
  if (component != along_x) return;
  Field<double>& p_xi = change_xi_[1];
  span_.differentiate(state.p, p_xi);
  for_each_row(extent_, [&](int plane, int j) {
    const double* xi = p_xi.row(plane, j);
    double* sum = gradient.row(plane, j);
    for (int i = 0; i < extent_.n_theta; ++i) sum[i] += xi[i];
  });
}

// Minus what the guess leaves of a component's equation, integrated over the cells.
void Fluid::subtract_equation(const FluidState& state, std::size_t component, double* right) {
  const BackwardDifference& D = step_.D;
  const bool has_span = span_.has_span(), has_gradient = has_pressure_gradient(component);
  const auto c = static_cast<int>(component);
  Field<double>&f = guess_[component], &f_xi = change_xi_[0], &carried = change_[0];
  extend_velocity(state, c, f, false);
  if (has_span) span_.differentiate(f, f_xi);
  for (int plane = 0; plane < extent_.planes; ++plane) {
    carry_plane(plane, f, has_span ? &f_xi : nullptr);
    for (int j = 0; j < extent_.n_rho; ++j)
      std::copy_n(carried_.row(0, j), extent_.n_theta, carried.row(plane, j));
  }
  if (has_span) {  // in the operator, on the change from the guess, aliases are of no account
    const std::size_t points = carried.values().size() / static_cast<std::size_t>(extent_.planes);
    span_.dealias(carried.values().data(), points, points);
  }
  extend_velocity(state, c, f, true);
  double* to = right;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    balance_plane(plane, f, has_span ? &f_xi : nullptr, true);
    for (int j = 0; j < extent_.n_rho; ++j)
      for (int i = 0; i < extent_.n_theta; ++i) *to++ = balance_.row(0, j)[i] / parameters_.Re;
  }
  add_x_flux(1 / parameters_.Re, f_xi, right);
  Field<double>& p_c = change_[1];
  if (has_gradient) find_pressure_gradient(state, component, p_c);
  // What drives the stream drives all of the fluid alike.
  const double drive = step_.rise_of_stream * risen_stream(c);
  for_each_row(extent_, [&](int plane, int j) {
    const double *u = state.u[component].row(plane, j),
                 *u_last = state.u_last[component].row(plane, j);
    const double *guess = f.row(plane, j), *volume = metrics_.volume.row(plane, j);
    const double* convected = carried.row(plane, j);
    const double* push = has_gradient ? p_c.row(plane, j) : nullptr;
    for (int i = 0; i < extent_.n_theta; ++i)
      *right++ -= volume[i] * (D.next * guess[i] + D.last * u[i] + D.before * u_last[i] +
                               convected[i] + (has_gradient ? push[i] : 0.0) - drive);
  });
}

// What the pressure has to make free of divergence: the predicted velocity and dt' grad p^n through
// the faces, nothing through the flag yet.
void Fluid::pose_projection(FluidState& state) {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const bool has_span = span_.has_span();
  const double dt = 1 / step_.D.next;
  if (step_.is_start)
    std::ranges::fill(outer_pressure_, 0.0);
  else
    find_outer_pressure(guess_);
  for (std::size_t c = 0; c < guess_.size(); ++c) {
    if (!step_.is_start && has_pressure_gradient(c)) {
      find_pressure_gradient(state, c, change_[0]);
      combine(1, guess_[c], dt, change_[0], guess_[c]);
    }
    for (int plane = 0; plane < extent_.planes; ++plane) guess_[c].wrap_theta(plane, 0, n_rho);
  }
  const Field<double>* u_x = has_span ? &guess_[along_x] : nullptr;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    velocity_flux(metrics_, plane, u_x, guess_[along_y], guess_[along_z], flux_rho_, flux_theta_);
    const FaceMetrics<double>& faces = metrics_.rho_faces;
    const auto outside = [&](const Field<double>& f, int i) {
      return outside_value(f.row(plane, n_rho - 1)[i], f.row(plane, n_rho - 2)[i]);
    };
    for (int i = 0; i < n_theta; ++i) {
      double outer = faces.area_y.row(plane, n_rho)[i] * outside(guess_[along_y], i) +
                     faces.area_z.row(plane, n_rho)[i] * outside(guess_[along_z], i);
      if (has_span) outer += faces.area_x.row(plane, n_rho)[i] * outside(guess_[along_x], i);
      flux_rho_.row(plane, 0)[i] = 0;
      flux_rho_.row(plane, n_rho)[i] = outer;
    }
  }
  if (has_span)
    for_each_row(extent_, [&](int plane, int j) {
      const double *u = u_x->row(plane, j), *volume = metrics_.volume.row(plane, j);
      double* flux = change_xi_[0].row(plane, j);
      for (int i = 0; i < n_theta; ++i) flux[i] = volume[i] * u[i];
    });
  subtract_outer_gradient(dt, change_[1]);
  Field<double>& divergence = change_[0];  // of the fluxes, integrated over the cells
  std::ranges::fill(divergence.values(), 0.0);
  for (int plane = 0; plane < extent_.planes; ++plane)
    add_balance(plane, flux_rho_, flux_theta_, divergence);
  pack(divergence, right_.data());
  add_x_flux(1, change_xi_[0], right_.data());
  for (std::size_t cell = 0; cell < extent_.cells(); ++cell) right_[cell] /= dt;
  if (step_.is_start) {
    std::ranges::fill(solution_, 0.0);
  } else {
    combine(step_.D.guess_last, state.p, step_.D.guess_before, state.p_last, change_[0]);
    pack(change_[0], solution_.data());
  }
  std::swap(state.p, state.p_last);
  step_.is_posed = true;
}

// The wall's velocity through the flag's faces, into what was posed.
void Fluid::impose_wall_flux() {
  const FaceMetrics<double>& faces = metrics_.rho_faces;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    double* flux = flux_rho_.row(plane, 0);
    double* right = right_.data() + static_cast<std::size_t>(plane) * extent_.cells_of_plane();
    for (int i = 0; i < extent_.n_theta; ++i) {
      const std::size_t face = extent_.wall_face(plane, i);
      double through = faces.area_y.row(plane, 0)[i] * wall_velocity_[along_y][face] +
                       faces.area_z.row(plane, 0)[i] * wall_velocity_[along_z][face];
      if (span_.has_span())
        through += faces.area_x.row(plane, 0)[i] * wall_velocity_[along_x][face];
      right[i] -= (through - flux[i]) * step_.D.next;
      flux[i] = through;
    }
  }
}

void Fluid::set_wall_velocity(std::size_t component, std::span<const double> velocity) {
  std::ranges::copy(velocity, wall_velocity_[component].begin());
}

void Fluid::begin_step(FluidState& state, const WallShape& wall, double dt) {
  step_ = {BackwardDifference(dt, state.previous_dt), state.t + dt, dt, 0, false, false, {}};
  if (parameters_.ramp > 0)
    step_.rise_of_stream = step_.D.derivative(
        smooth_rise(state.t + dt, parameters_.ramp), smooth_rise(state.t, parameters_.ramp),
        smooth_rise(state.t - state.previous_dt, parameters_.ramp));
  StopWatch watch;
  move_grid(state, wall);
  find_grid_velocity(state);
  step_.summary.seconds.grid = watch.lap();
  update_all_metrics(state.grid[0]);
  step_.summary.seconds.metrics = watch.lap();
  predict(state);
  step_.summary.seconds.prediction = watch.lap();
}

int Fluid::solve_pressure(FluidState& state, double tolerance) {
  StopWatch watch;
  if (!step_.is_posed) pose_projection(state);
  impose_wall_flux();
  const KrylovSummary solved = pressure_.solve(right_.data(), solution_.data(), tolerance);
  if (!solved.converged)
    fail(state.t, fmt::format("the pressure solver stopped after {} iterations with an error of "
                              "{:.3g}; a smaller dns.dt or a finer grid may help",
                              solved.iterations, solved.residual));
  step_.summary.pressure_iterations += solved.iterations;
  unpack(solution_.data(), state.p);
  step_.summary.seconds.projection += watch.lap();
  return solved.iterations;
}

// Takes the pressure's gradient from the fluxes and the velocity.
FluidStepSummary Fluid::finish_step(FluidState& state) {
  StopWatch watch;
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const bool has_span = span_.has_span();
  const double dt = 1 / step_.D.next;
  extend_pressure(state.p, 0);  // the outer pressure's part was posed
  Field<double>&p_xi = change_xi_[0], &across_rho = change_[0], &across_theta = change_[1];
  if (has_span) span_.differentiate(state.p, p_xi);
  const Field<double>* slope = has_span ? &p_xi : nullptr;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    gradient_flux(metrics_, plane, state.p, slope, across_rho, across_theta);
    for (int j = 0; j <= n_rho; ++j) {
      double *rho = flux_rho_.row(plane, j), *theta = flux_theta_.row(plane, j);
      const double *p_rho = across_rho.row(plane, j), *p_theta = across_theta.row(plane, j);
      if (j > 0)
        for (int i = 0; i < n_theta; ++i) rho[i] -= dt * p_rho[i];
      if (j < n_rho)
        for (int i = 0; i <= n_theta; ++i) theta[i] -= dt * p_theta[i];
    }
    const double* outer = flux_rho_.row(plane, n_rho);
    for (int i = 0; i < n_theta; ++i) state.is_inflow[extent_.wall_face(plane, i)] = outer[i] < 0;
  }
  extend_pressure(state.p);
  for (std::size_t c = 0; c < guess_.size(); ++c) {
    std::swap(state.u_last[c], state.u[c]);
    if (has_pressure_gradient(c)) {
      find_pressure_gradient(state, c, state.u[c]);
      combine(1, guess_[c], -dt, state.u[c], state.u[c]);
    } else {
      state.u[c] = guess_[c];
    }
  }
  FluidStepSummary& summary = step_.summary;
  summary.CFL = ranks::largest(summary.CFL);
  summary.least_area = ranks::least(summary.least_area);
  summary.largest_wall_area = ranks::largest(summary.largest_wall_area);
  summary.grid_passes = static_cast<int>(ranks::largest(summary.grid_passes));
  state.t = step_.t;
  state.previous_dt = step_.dt;
  summary.seconds.projection += watch.lap();
  return summary;
}

FluidStepSummary Fluid::advance(FluidState& state, const WallMotion& wall, double dt) {
  wall(state.t + dt, wall_);
  begin_step(state, wall_, dt);
  solve_pressure(state, tolerances_.pressure);
  return finish_step(state);
}

FluidState Fluid::impulsive_start(const WallMotion& wall, double t) {
  FluidState state;
  state.t = t;
  step_ = {BackwardDifference(1, 0), t, 1, 0, false, true, {}};
  state.grid.assign(3, Displacement<double>(extent_));
  wall(t, wall_);
  bool fits = true;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    const std::size_t first = extent_.wall_face(plane, 0);
    constexpr int most_passes = 300;
    const EllipticGridSummary found =
        elliptic_.follow(plane, wall_.y.data() + first, wall_.z.data() + first, state.grid[0],
                         tolerances_.grid, most_passes);
    fits = fits && found.least_area > 0;
  }
  if (ranks::any(!fits)) fail(t, "no grid fits the flag: it bends too sharply for dns.n_theta");
  state.grid[1] = state.grid[0];
  state.grid[2] = state.grid[0];
  update_all_metrics(state.grid[0]);
  for (int c = 0; c < components_; ++c) {
    state.u.emplace_back(extent_, stream(c));
    state.u_last.emplace_back(extent_, stream(c));
    state.u_change.emplace_back(extent_);
    guess_[static_cast<std::size_t>(c)] = state.u.back();
    std::ranges::fill(wall_velocity_[static_cast<std::size_t>(c)], 0.0);
  }
  state.p = state.p_last = Field<double>(extent_);
  state.is_inflow.resize(extent_.wall_faces());
  solve_pressure(state, tolerances_.pressure);
  finish_step(state);
  state.previous_dt = 0;
  std::ranges::fill(state.p.values(), 0.0);
  state.u_last = state.u;
  return state;
}

}  // namespace pennon::dns

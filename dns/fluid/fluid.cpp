#include "dns/fluid/fluid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "common/parallel/interrupted_step.hpp"
#include "common/parallel/ranks.hpp"
#include "common/smooth_rise.hpp"
#include "common/stop_watch.hpp"

namespace pennon::dns {

Fluid::Fluid(const OGrid& grid, Span span, const FluidParameters& parameters,
             const FluidTolerances& tolerances, const Upwinding& upwinding)
    : grid_(grid),
      span_(std::move(span)),
      parameters_(parameters),
      tolerances_(tolerances),
      extent_{span_.local_planes(), grid.n_rho(), grid.n_theta()},
      components_(span_.has_span() || parameters.U != 0 ? 3 : 2),
      scratch_(extent_),
      moving_(grid_, span_, tolerances_, scratch_),
      krylov_space_(std::make_shared<KrylovSpace>(2 * extent_.cells())),
      prediction_(grid_, span_, moving_, parameters_, tolerances_, upwinding, manufactured_,
                  components_, scratch_, krylov_space_),
      projection_(grid_, span_, moving_, scratch_, krylov_space_),
      wall_{std::vector<double>(extent_.wall_faces()), std::vector<double>(extent_.wall_faces())},
      wall_velocity_(static_cast<std::size_t>(components_),
                     std::vector<double>(extent_.wall_faces())),
      velocity_(static_cast<std::size_t>(components_), Field<double>(extent_)) {}

FluidStepSummary Fluid::advance(FluidState& state, const WallMotion& wall, double dt) {
  wall(state.t + dt, wall_);
  begin_step(state, wall_, dt);
  solve_pressure(state, tolerances_.pressure);
  return finish_step(state);
}

// The grid moves, then D_t v* + ((v - v_g) . grad) v = - grad p^n + 1/Re lap v*.
void Fluid::begin_step(FluidState& state, const WallShape& wall, double dt) {
  StopWatch watch;
  projection_.begin();
  set_step(state.t + dt, dt, state);
  moving_.move(step_, wall, state, summary_);
  moving_.find_velocity(step_, state, wall_velocity_);
  if (manufactured_.wall_velocity) find_wall_velocity(state);
  summary_.seconds.grid = watch.lap();
  moving_.update_metrics(state.grid[0]);
  summary_.seconds.metrics = watch.lap();
  ranks::stop_if_interrupted();
  projection_.find_outer_pressure(step_, state.u);
  projection_.extend_pressure(state.p);
  prediction_.predict(step_, wall_velocity_, state, velocity_, summary_);
  summary_.seconds.prediction = watch.lap();
}

// div v = 0 with v = v* + dt' grad p^n - dt' grad p and the wall's velocity as it is now.
int Fluid::solve_pressure(FluidState& state, double tolerance) {
  StopWatch watch;
  if (!projection_.is_posed()) projection_.pose(step_, is_start_, state, velocity_);
  projection_.impose_wall_velocity(step_, wall_velocity_);
  const KrylovSummary solved = projection_.solve(tolerance, state.p);
  if (!solved.converged)
    fail_at(state.t, fmt::format("the pressure solver stopped after {} iterations with an error of "
                                 "{:.3g}; a smaller dns.dt or a finer grid may help",
                                 solved.iterations, solved.residual));
  summary_.pressure_iterations += solved.iterations;
  summary_.seconds.projection += watch.lap();
  return solved.iterations;
}

// v = v* + dt' grad p^n - dt' grad p, in the cells and through their faces.
FluidStepSummary Fluid::finish_step(FluidState& state) {
  StopWatch watch;
  projection_.finish(step_, velocity_, state);
  summary_.CFL = ranks::largest(summary_.CFL);
  summary_.least_area = ranks::least(summary_.least_area);
  summary_.largest_wall_area = ranks::largest(summary_.largest_wall_area);
  summary_.grid_passes = static_cast<int>(ranks::largest(summary_.grid_passes));
  state.t = step_.t;
  state.previous_dt = step_.dt;
  summary_.seconds.projection += watch.lap();
  return summary_;
}

// To the time t, from the last two of the state. The stream rises smoothly from rest over
// parameters_.ramp, or is there at once.
void Fluid::set_step(double t, double dt, const FluidState& state) {
  step_ = {BackwardDifference(dt, state.previous_dt), t, dt, {}, {}};
  summary_ = {};
  is_start_ = false;
  const double ramp = parameters_.ramp, risen = smooth_rise(t, ramp);
  double rate = 0;
  if (ramp > 0)
    rate = step_.D.derivative(risen, smooth_rise(state.t, ramp),
                              smooth_rise(state.t - state.previous_dt, ramp));
  const std::array<double, 3> stream = uniform_stream(parameters_.U);
  for (const Component c : {along_y, along_z, along_x}) {
    step_.stream[c] = risen * stream[c];
    step_.drive[c] = rate * stream[c];
  }
}

FluidState Fluid::impulsive_start(const WallMotion& wall, double t) {
  FluidState state;
  state.t = t;
  projection_.begin();
  set_step(t, 1, state);
  is_start_ = true;
  state.grid.assign(3, Displacement<double>(extent_));
  wall(t, wall_);
  moving_.fit(wall_, t, state.grid[0]);
  state.grid[1] = state.grid[0];
  state.grid[2] = state.grid[0];
  moving_.update_metrics(state.grid[0]);
  for (std::size_t c = 0; c < velocity_.size(); ++c) {
    state.u.emplace_back(extent_, stream(c));
    state.u_last.emplace_back(extent_, stream(c));
    state.u_change.emplace_back(extent_);
    velocity_[c] = state.u.back();
    std::ranges::fill(wall_velocity_[c], 0.0);
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

// As the manufactured solution has it.
void Fluid::find_wall_velocity(const FluidState& state) {
  for (int plane = 0; plane < extent_.planes; ++plane)
    for (int i = 0; i < extent_.n_theta; ++i) {
      const auto [y, z] = moving_.wall_centre(state.grid[0], plane, i);
      const std::array<double, 3> velocity =
          manufactured_.wall_velocity(step_.t, span_.x(plane), y, z);
      for (std::size_t c = 0; c < wall_velocity_.size(); ++c)
        wall_velocity_[c][extent_.wall_face(plane, i)] = velocity[axis_of[c]];
    }
}

void Fluid::set_wall_velocity(std::size_t component, std::span<const double> velocity) {
  std::ranges::copy(velocity, wall_velocity_[component].begin());
}

std::array<double, 2> Fluid::centre(const FluidState& state, int plane, int j, int i) const {
  return moving_.centre(state.grid[0], plane, j, i);
}

void Fluid::extend_velocity(std::size_t component, Field<double>& f) const {
  for (int plane = 0; plane < extent_.planes; ++plane) {
    extend_inward(plane, wall_velocity_[component].data() + extent_.wall_face(plane, 0), f);
    extend_outward_for_friction(plane, f);
  }
}

}  // namespace pennon::dns

#include "dns/fluid/prediction.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/parallel/ranks.hpp"
#include "dns/fluid/span_terms.hpp"
#include "dns/grid/packing.hpp"

namespace pennon::dns {

Prediction::Prediction(const OGrid& grid, const Span& span, const MovingGrid& moving,
                       const FluidParameters& parameters, const FluidTolerances& tolerances,
                       const Upwinding& upwinding, const Manufactured& manufactured, int components,
                       FluidScratch& scratch, const std::shared_ptr<KrylovSpace>& space)
    : span_(span),
      moving_(moving),
      parameters_(parameters),
      tolerances_(tolerances),
      upwinding_(upwinding),
      manufactured_(manufactured),
      extent_{span.local_planes(), grid.n_rho(), grid.n_theta()},
      components_(components),
      scratch_(scratch),
      widening_(outer_widening(grid)),
      at_rest_(static_cast<std::size_t>(grid.n_theta())),
      lines_(extent_),
      in_plane_(
          2 * extent_.cells(), {"velocity", 200, 10},
          [this](const double* in, double* out) {
            multiply({along_y, along_x}, in, out);
          },
          [this](const double* in, double* out) { lines_.invert(2, in, out); }, space),
      along_span_(
          components > 2 ? extent_.cells() : 0, {"velocity", 200, 10},
          [this](const double* in, double* out) {
            multiply({along_x, along_x + 1}, in, out);
          },
          [this](const double* in, double* out) { lines_.invert(1, in, out); }, space) {}

void Prediction::predict(const FluidStep& step, const WallVelocity& wall_velocity,
                         FluidState& state, std::vector<Field<double>>& velocity,
                         FluidStepSummary& summary) {
  for (std::size_t c = 0; c < velocity.size(); ++c)
    combine(step.D.guess_last, state.u[c], step.D.guess_before, state.u_last[c], velocity[c]);
  problem_ = {};  // a prediction that threw may have left its own
  problem_ = {&step,
              &state,
              &velocity,
              scratch_.fields.lease("convecting velocity along s"),
              scratch_.fields.lease("convecting velocity along t"),
              false};
  find_convection(step, velocity, summary);
  lines_.prepare(moving_.metrics(), *problem_.C_s, *problem_.C_t, step.D.next, 1 / parameters_.Re);
  // The component along x apart, so that a cross-flow changes nothing across it, to the last bit.
  solve({along_y, along_x}, wall_velocity, state, velocity, summary);
  if (components_ > 2) solve({along_x, along_x + 1}, wall_velocity, state, velocity, summary);
  // Only now: until here the extrapolated velocity carries all of them.
  for (std::size_t c = 0; c < velocity.size(); ++c)
    combine(1, velocity[c], 1, state.u_change[c], velocity[c]);
  problem_ = {};
}

// C = v - v_g of the extrapolated velocity.
void Prediction::find_convection(const FluidStep& step, const std::vector<Field<double>>& velocity,
                                 FluidStepSummary& summary) {
  const bool has_span = span_.has_span();
  for_each_row(extent_, [&](int plane, int j) {
    double *C_s = problem_.C_s->row(plane, j), *C_t = problem_.C_t->row(plane, j);
    convecting_velocity(moving_.metrics(), plane, j, has_span ? &velocity[along_x] : nullptr,
                        velocity[along_y], velocity[along_z], moving_.velocity_y(),
                        moving_.velocity_z(), C_s, C_t);
    for (int i = 0; i < extent_.n_theta; ++i)
      summary.CFL = std::max(summary.CFL, (std::abs(C_s[i]) + std::abs(C_t[i])) * step.dt);
  });
  problem_.varies_along_x = has_span && must_vary_along_x(step, velocity[along_x]);
}

// Where neither friction nor convection along x goes far in a step, they may act on the
// extrapolated velocity alone. That is of second order too, and spares the solver its transforms.
bool Prediction::must_vary_along_x(const FluidStep& step, const Field<double>& u_x) const {
  double fastest = 0;
  for_each_row(extent_, [&](int plane, int j) {
    for (int i = 0; i < extent_.n_theta; ++i)
      fastest = std::max(fastest, std::abs(u_x.row(plane, j)[i]));
  });
  const double k = std::numbers::pi * span_.planes() / span_.length(), dt = step.dt_of_pressure();
  constexpr double little_friction = 0.1, little_convection = 0.05;  // of a mode in a step
  return k * k * dt / parameters_.Re > little_friction ||
         k * dt * ranks::largest(fastest) > little_convection;
}

void Prediction::solve(const Components& components, const WallVelocity& wall_velocity,
                       FluidState& state, std::vector<Field<double>>& velocity,
                       FluidStepSummary& summary) {
  const std::size_t cells = extent_.cells();
  const VectorLease right = scratch_.vectors.lease("right side of the velocity's equation"),
                    change = scratch_.vectors.lease("change of the velocity");
  for (std::size_t c = components.first; c < components.end; ++c) {
    double* right_of_c = right->data() + (c - components.first) * cells;
    find_right_side(wall_velocity, state, c, velocity, right_of_c);
    if (manufactured_.force) add_force(state, c, right_of_c);
    pack(state.u_change[c], change->data() + (c - components.first) * cells);
  }
  Krylov& krylov = components.first == along_x ? along_span_ : in_plane_;
  const KrylovSummary solved = krylov.solve(right->data(), change->data(), tolerances_.velocity);
  if (!solved.converged)
    fail_at(state.t, fmt::format("the viscous solver stopped after {} iterations with an error of "
                                 "{:.3g}; a smaller dns.dt or, where the boundary layer is "
                                 "thinner than a cell, a smaller dns.wall_spacing may help",
                                 solved.iterations, solved.residual));
  summary.velocity_iterations = std::max(summary.velocity_iterations, solved.iterations);
  for (std::size_t c = components.first; c < components.end; ++c)
    unpack(change->data() + (c - components.first) * cells, state.u_change[c]);
}

const Field<double>* Prediction::u_x() const {
  return problem_.velocity->size() > along_x ? &(*problem_.velocity)[along_x] : nullptr;
}

// Minus the residual of the extrapolated velocity, of one component. Leaves that component of
// `velocity` with the ghosts of its friction.
void Prediction::find_right_side(const WallVelocity& wall_velocity, const FluidState& state,
                                 std::size_t component, std::vector<Field<double>>& velocity,
                                 double* right) {
  const Metrics<double>& metrics = moving_.metrics();
  const double nu = 1 / parameters_.Re;
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  Field<double>& f = velocity[component];
  FieldLease f_xi, gradient;
  if (span_.has_span()) f_xi = scratch_.fields.lease("derivative of the velocity by x");
  const FieldLease convected = scratch_.fields.lease("convective derivative");
  convect(wall_velocity, component, f_xi.get(), velocity, *convected);
  if (has_pressure_gradient(span_, component)) {
    gradient = scratch_.fields.lease("pressure gradient of the last step");
    find_pressure_gradient(metrics, span_, component, state.p, scratch_, *gradient);
  }
  const FieldLease laplacian = scratch_.planes.lease("Laplacian of the velocity");
  const BackwardDifference& D = problem_.step->D;
  const double drive = problem_.step->drive[component];
  double* to = right;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    extend_outward_for_friction(plane, f);
    integrated_laplacian(metrics, plane, f, f_xi.get(), true, *laplacian);
    for (int j = 0; j < n_rho; ++j, to += n_theta) {
      const double *now = f.row(plane, j), *last = state.u[component].row(plane, j),
                   *before = state.u_last[component].row(plane, j);
      const auto rate = [&](int i) { return D.derivative(now[i], last[i], before[i]) - drive; };
      const MomentumRow<double> row{metrics.volume.row(plane, j), convected->row(plane, j),
                                    laplacian->row(0, j)};
      if (gradient) {
        const double* push = gradient->row(plane, j);
        momentum_residual(
            n_theta, row, nu, rate, [&](int i) { return push[i]; }, to);
      } else {
        momentum_residual(n_theta, row, nu, rate, no_term, to);
      }
      for (int i = 0; i < n_theta; ++i) to[i] = -to[i];
    }
    if (f_xi) gradient_flux_along_x(metrics, plane, f, *f_xi);
  }
  if (f_xi) add_flux_along_x(span_, nu, *f_xi, right);
}

// (C . grad) of a component, without aliases along x, and its derivative by xi; leaves the
// component with the ghosts of its convection.
void Prediction::convect(const WallVelocity& wall_velocity, std::size_t component,
                         Field<double>* f_xi, std::vector<Field<double>>& velocity,
                         Field<double>& convected) {
  Field<double>& f = velocity[component];
  const OuterBoundary<double> outer{moving_.metrics().rho_faces, widening_,
                                    problem_.state->is_inflow, problem_.step->stream};
  for (int plane = 0; plane < extent_.planes; ++plane) {
    extend_inward(plane, wall_velocity[component].data() + extent_.wall_face(plane, 0), f);
    extend_outward_for_convection(plane, outer, velocity[along_y], velocity[along_z], component, f);
  }
  if (f_xi) span_.differentiate(f, *f_xi);
  const FieldLease of_plane = scratch_.planes.lease("convective derivative of a plane");
  for (int plane = 0; plane < extent_.planes; ++plane) {
    convective_derivative(plane, *problem_.C_s, *problem_.C_t, u_x(), f, f_xi, upwinding_,
                          *of_plane);
    for (int j = 0; j < extent_.n_rho; ++j)
      std::copy_n(of_plane->row(0, j), extent_.n_theta, convected.row(plane, j));
  }
  if (!f_xi) return;  // in the operator, on the change of the velocity, aliases are of no account
  const std::size_t points = convected.values().size() / static_cast<std::size_t>(extent_.planes);
  span_.dealias(convected.values().data(), points, points);
}

void Prediction::add_force(const FluidState& state, std::size_t component, double* right) const {
  for_each_row(extent_, [&](int plane, int j) {
    for (int i = 0; i < extent_.n_theta; ++i) {
      const auto [y, z] = moving_.centre(state.grid[0], plane, j, i);
      *right++ += moving_.metrics().volume.row(plane, j)[i] *
                  manufactured_.force(problem_.step->t, span_.x(plane), y, z)[axis_of[component]];
    }
  });
}

// The residual's derivative by the velocity: for each component of a change, which is zero at the
// flag and in the stream.
void Prediction::multiply(const Components& components, const double* in, double* out) {
  const Metrics<double>& metrics = moving_.metrics();
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const std::size_t cells = extent_.cells();
  const double nu = 1 / parameters_.Re;
  constexpr std::array names = {"change along y or x", "change along z"};
  constexpr std::array slope_names = {"slope of the change along y or x",
                                      "slope of the change along z"};
  std::array<FieldLease, 2> f, f_xi;
  for (std::size_t k = 0; k < components.count(); ++k) {
    f[k] = scratch_.fields.lease(names[k]);
    if (problem_.varies_along_x) f_xi[k] = scratch_.fields.lease(slope_names[k]);
    unpack(in + k * cells, *f[k]);
    for (int plane = 0; plane < extent_.planes; ++plane)
      extend_inward(plane, at_rest_.data(), *f[k]);
  }
  const OuterBoundary<double> outer{
      metrics.rho_faces, widening_, problem_.state->is_inflow, {0, 0, 0}};
  // Where fluid enters, the components in the plane are coupled; that along x needs no other.
  const Field<double>&v = *f[0], &w = f[1] ? *f[1] : *f[0];
  for (std::size_t k = 0; k < components.count(); ++k) {
    for (int plane = 0; plane < extent_.planes; ++plane)
      extend_outward_for_convection(plane, outer, v, w, components.first + k, *f[k]);
    if (f_xi[k]) span_.differentiate(*f[k], *f_xi[k]);
  }
  const FieldLease convected = scratch_.planes.lease("convective derivative of a plane"),
                   laplacian = scratch_.planes.lease("Laplacian of the velocity");
  const double D_next = problem_.step->D.next;
  for (int plane = 0; plane < extent_.planes; ++plane)
    for (std::size_t k = 0; k < components.count(); ++k) {
      convective_derivative(plane, *problem_.C_s, *problem_.C_t, u_x(), *f[k], f_xi[k].get(),
                            upwinding_, *convected);
      extend_outward_for_friction(plane, *f[k]);
      integrated_laplacian(metrics, plane, *f[k], f_xi[k].get(), true, *laplacian);
      if (f_xi[k]) gradient_flux_along_x(metrics, plane, *f[k], *f_xi[k]);
      double* to = out + k * cells + static_cast<std::size_t>(plane) * extent_.cells_of_plane();
      for (int j = 0; j < n_rho; ++j, to += n_theta) {
        const double* change = f[k]->row(plane, j);
        momentum_residual<double>(
            n_theta, {metrics.volume.row(plane, j), convected->row(0, j), laplacian->row(0, j)}, nu,
            [&](int i) { return D_next * change[i]; }, no_term, to);
      }
    }
  for (std::size_t k = 0; k < components.count(); ++k)
    if (f_xi[k]) add_flux_along_x(span_, -nu, *f_xi[k], out + k * cells);
}

}  // namespace pennon::dns

#include "dns/fluid/projection.hpp"

#include <algorithm>

#include "dns/fluid/equations/continuity.hpp"
#include "dns/fluid/span_terms.hpp"
#include "dns/grid/packing.hpp"

namespace pennon::dns {

Projection::Projection(const OGrid& grid, const Span& span, const MovingGrid& moving,
                       FluidScratch& scratch, const std::shared_ptr<KrylovSpace>& space)
    : span_(span),
      moving_(moving),
      extent_{span.local_planes(), grid.n_rho(), grid.n_theta()},
      scratch_(scratch),
      krylov_(
          extent_.cells(), {"pressure", 200, 30},
          [this](const double* in, double* out) { multiply(in, out); },
          [this](const double* in, double* out) { invert_flat(in, out); }, space),
      outer_pressure_(extent_.wall_faces()) {
  for (int plane = 0; plane < extent_.planes; ++plane)
    if (const int waves = span_.waves(plane); !span_.is_dropped(plane) && !flat_.contains(waves))
      flat_.try_emplace(waves, grid, Span::wavenumber(waves, span_.planes(), span_.length()));
  for (FieldLease* flux : {&flux_rho_, &flux_theta_}) {  // none before the first step
    *flux = scratch_.fields.lease(flux == &flux_rho_ ? "flux across rho" : "flux across theta");
    std::ranges::fill((*flux)->values(), 0.0);
  }
}

void Projection::begin() {
  is_posed_ = false;
  flux_rho_.release();
  flux_theta_.release();
  right_side_.release();
  solution_.release();
}

void Projection::pose(const FluidStep& step, bool is_start, FluidState& state,
                      std::vector<Field<double>>& velocity) {
  const double dt_of_pressure = step.dt_of_pressure();
  if (is_start)
    std::ranges::fill(outer_pressure_, 0.0);
  else
    find_outer_pressure(step, velocity);
  for (std::size_t c = 0; c < velocity.size(); ++c) {
    if (!is_start && has_pressure_gradient(span_, c)) {
      const FieldLease gradient = scratch_.fields.lease("pressure gradient of the last step");
      find_pressure_gradient(moving_.metrics(), span_, c, state.p, scratch_, *gradient);
      combine(1, velocity[c], dt_of_pressure, *gradient, velocity[c]);
    }
    for (int plane = 0; plane < extent_.planes; ++plane)
      velocity[c].wrap_theta(plane, 0, extent_.n_rho);
  }
  flux_rho_ = scratch_.fields.lease("flux across rho");
  flux_theta_ = scratch_.fields.lease("flux across theta");
  find_fluxes(velocity);
  FieldLease flux_x;
  if (span_.has_span()) {
    flux_x = scratch_.fields.lease("flux along x");
    for_each_row(extent_, [&](int plane, int j) {
      const double *u = velocity[along_x].row(plane, j),
                   *volume = moving_.metrics().volume.row(plane, j);
      double* flux = flux_x->row(plane, j);
      for (int i = 0; i < extent_.n_theta; ++i) flux[i] = volume[i] * u[i];
    });
  }
  subtract_outer_gradient(dt_of_pressure, flux_x.get());
  right_side_ = scratch_.vectors.lease("divergence of the predicted velocity");
  solution_ = scratch_.vectors.lease("pressure");
  {
    const FieldLease divergence = scratch_.fields.lease("divergence");  // integrated over the cells
    std::ranges::fill(divergence->values(), 0.0);
    for (int plane = 0; plane < extent_.planes; ++plane)
      add_divergence(plane, *flux_rho_, *flux_theta_, *divergence);
    pack(*divergence, right_side_->data());
  }
  if (flux_x) add_flux_along_x(span_, 1, *flux_x, right_side_->data());
  for (std::size_t cell = 0; cell < extent_.cells(); ++cell) (*right_side_)[cell] /= dt_of_pressure;
  if (is_start) {
    std::ranges::fill(*solution_, 0.0);
  } else {
    const FieldLease guess = scratch_.fields.lease("extrapolated pressure");
    combine(step.D.guess_last, state.p, step.D.guess_before, state.p_last, *guess);
    pack(*guess, solution_->data());
  }
  std::swap(state.p, state.p_last);
  is_posed_ = true;
}

// Of the velocity at the cells; none through the flag.
void Projection::find_fluxes(const std::vector<Field<double>>& velocity) {
  const Field<double>* u_x = span_.has_span() ? &velocity[along_x] : nullptr;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    velocity_flux(moving_.metrics(), plane, u_x, velocity[along_y], velocity[along_z], *flux_rho_,
                  *flux_theta_);
    std::fill_n(flux_rho_->row(plane, 0), extent_.n_theta, 0.0);
    outer_flux(moving_.metrics(), plane, velocity, flux_rho_->row(plane, extent_.n_rho));
  }
}

// Takes from the fluxes what the pressure of the outer boundary makes of the gradient by itself:
// that of a field which is 0 at the cells and twice that pressure in the ghosts. No area there has
// a part along x.
void Projection::subtract_outer_gradient(double dt_of_pressure, Field<double>* flux_x) {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const Metrics<double>& metrics = moving_.metrics();
  const FieldLease outer = scratch_.fields.lease("pressure of the outer boundary"),
                   of_row = scratch_.planes.lease("gradient's flux through a row");
  double* through = of_row->row(0, 0);
  for (int plane = 0; plane < extent_.planes; ++plane) {
    for (const int j : {n_rho - 2, n_rho - 1}) std::fill_n(outer->row(plane, j), n_theta, 0.0);
    for (int i = 0; i < n_theta; ++i)
      outer->row(plane, n_rho)[i] = 2 * outer_pressure_[extent_.wall_face(plane, i)];
    outer->wrap_theta(plane, n_rho - 2, n_rho + 1);
    gradient_flux_across_rho<double>(metrics, plane, n_rho, *outer, nullptr, through);
    for (int i = 0; i < n_theta; ++i)
      flux_rho_->row(plane, n_rho)[i] -= dt_of_pressure * through[i];
    gradient_flux_across_theta<double>(metrics, plane, n_rho - 1, *outer, nullptr, through);
    for (int i = 0; i <= n_theta; ++i)
      flux_theta_->row(plane, n_rho - 1)[i] -= dt_of_pressure * through[i];
    if (!flux_x) continue;
    const double *s_x = metrics.s_x.row(plane, n_rho - 1),
                 *volume = metrics.volume.row(plane, n_rho - 1), *p = outer->row(plane, n_rho);
    double* flux = flux_x->row(plane, n_rho - 1);
    for (int i = 0; i < n_theta; ++i) flux[i] -= dt_of_pressure * volume[i] * s_x[i] * 0.5 * p[i];
  }
}

void Projection::impose_wall_velocity(const FluidStep& step, const WallVelocity& wall_velocity) {
  const FieldLease of_row = scratch_.planes.lease("flux through the wall");
  double* through = of_row->row(0, 0);
  for (int plane = 0; plane < extent_.planes; ++plane) {
    wall_flux(moving_.metrics(), plane, wall_velocity, through);
    double* flux = flux_rho_->row(plane, 0);
    double* right =
        right_side_->data() + static_cast<std::size_t>(plane) * extent_.cells_of_plane();
    for (int i = 0; i < extent_.n_theta; ++i) {
      right[i] -= (through[i] - flux[i]) * step.D.next;
      flux[i] = through[i];
    }
  }
}

KrylovSummary Projection::solve(double tolerance, Field<double>& p) {
  const KrylovSummary solved = krylov_.solve(right_side_->data(), solution_->data(), tolerance);
  unpack(solution_->data(), p);
  return solved;
}

void Projection::finish(const FluidStep& step, const std::vector<Field<double>>& velocity,
                        FluidState& state) {
  const double dt_of_pressure = step.dt_of_pressure();
  right_side_.release();
  solution_.release();
  extend_pressure(state.p, 0);  // pose() has taken the outer pressure's part
  {
    const FieldLease across_rho = scratch_.fields.lease("gradient's flux across rho"),
                     across_theta = scratch_.fields.lease("gradient's flux across theta");
    FieldLease p_xi;
    if (span_.has_span()) {
      p_xi = scratch_.fields.lease("derivative of the pressure by x");
      span_.differentiate(state.p, *p_xi);
    }
    for (int plane = 0; plane < extent_.planes; ++plane) {
      gradient_flux(moving_.metrics(), plane, state.p, p_xi.get(), *across_rho, *across_theta);
      subtract_pressure_flux(plane, dt_of_pressure, *across_rho, *across_theta, *flux_rho_,
                             *flux_theta_);
      const double* outer = flux_rho_->row(plane, extent_.n_rho);
      for (int i = 0; i < extent_.n_theta; ++i)
        state.is_inflow[extent_.wall_face(plane, i)] = outer[i] < 0;
    }
  }
  extend_pressure(state.p);
  for (std::size_t c = 0; c < velocity.size(); ++c) {
    std::swap(state.u_last[c], state.u[c]);
    if (has_pressure_gradient(span_, c)) {
      find_pressure_gradient(moving_.metrics(), span_, c, state.p, scratch_, state.u[c]);
      combine(1, velocity[c], -dt_of_pressure, state.u[c], state.u[c]);
    } else {
      state.u[c] = velocity[c];
    }
  }
  is_posed_ = false;
}

void Projection::find_outer_pressure(const FluidStep& step, const std::vector<Field<double>>& u) {
  for (int plane = 0; plane < extent_.planes; ++plane)
    dns::find_outer_pressure(plane, moving_.metrics().rho_faces, u[along_y], u[along_z],
                             step.stream[along_y],
                             outer_pressure_.data() + extent_.wall_face(plane, 0));
}

void Projection::extend_pressure(Field<double>& p, double share) const {
  for (int plane = 0; plane < extent_.planes; ++plane)
    dns::extend_pressure(plane, outer_pressure_.data() + extent_.wall_face(plane, 0), share, p);
}

// The integral of lap p over each cell, p = 0 at the outer boundary, no flux through the flag.
void Projection::multiply(const double* in, double* out) {
  const FieldLease p = scratch_.fields.lease("pressure in the operator"),
                   laplacian = scratch_.planes.lease("Laplacian of the pressure");
  FieldLease p_xi;
  unpack(in, *p);
  extend_pressure(*p, 0);
  if (span_.has_span()) {
    p_xi = scratch_.fields.lease("derivative of the pressure by x");
    span_.differentiate(*p, *p_xi);
  }
  double* to = out;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    integrated_laplacian(moving_.metrics(), plane, *p, p_xi.get(), false, *laplacian);
    if (p_xi) gradient_flux_along_x(moving_.metrics(), plane, *p, *p_xi);
    for (int j = 0; j < extent_.n_rho; ++j)
      to = std::copy_n(laplacian->row(0, j), extent_.n_theta, to);
  }
  if (p_xi) add_flux_along_x(span_, 1, *p_xi, out);
}

// The preconditioner: the same on the grid at rest, wave by wave.
void Projection::invert_flat(const double* in, double* out) {
  const std::size_t plane_cells = extent_.cells_of_plane();
  std::copy_n(in, extent_.cells(), out);
  span_.to_coefficients(out, plane_cells, plane_cells);
  for (int plane = 0; plane < extent_.planes; ++plane) {
    double* values = out + static_cast<std::size_t>(plane) * plane_cells;
    if (span_.is_dropped(plane)) {
      std::fill_n(values, plane_cells, 0.0);
      continue;
    }
    flat_.at(span_.waves(plane)).solve(values);
  }
  span_.to_values(out, plane_cells, plane_cells);
}

}  // namespace pennon::dns

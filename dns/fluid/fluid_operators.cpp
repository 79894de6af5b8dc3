// The boundary conditions of Fluid, and the operators that its solvers invert.
#include <algorithm>
#include <array>
#include <cmath>

#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/fluid.hpp"
#include "dns/grid/packing.hpp"

namespace pennon::dns {

void Fluid::extend_velocity(const FluidState& state, int component, Field<double>& f,
                            bool is_viscous) const {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    const std::size_t first = static_cast<std::size_t>(plane) * static_cast<std::size_t>(n_theta);
    extend_to_wall(plane, wall_velocity_[static_cast<std::size_t>(component)].data() + first, f);
    extend_outward(plane, is_viscous, f);
    if (!is_viscous) extend_inflow(plane, state.is_inflow, guess_, true, component, f);
    f.wrap_theta(plane, -2, n_rho + 2);
  }
}

// Where fluid enters, of a component of u: the velocity, or (without the stream) a change of it.
void Fluid::extend_inflow(int plane, const std::vector<bool>& is_inflow,
                          const std::vector<Field<double>>& u, bool with_stream, int component,
                          Field<double>& f) const {
  const FaceMetrics<double>& faces = metrics_.rho_faces;
  const double widening = std::exp(grid_.rho_face_step(extent_.n_rho));  // of cosh(rho + i theta)
  const Inflow<double> inflow{is_inflow, faces, widening,
                              u[0],      u[1],  with_stream ? stream(0) : 0.0};
  const std::array<const Field<double>*, 3> areas = {&faces.area_y, &faces.area_z, nullptr};
  reflect_inflow(plane, inflow, areas[static_cast<std::size_t>(component)],
                 with_stream ? stream(component) : 0.0, f);
}

// p = -u_n v'_n where fluid enters, 0 where it leaves.
void Fluid::find_outer_pressure(const std::vector<Field<double>>& u) {
  for (int plane = 0; plane < extent_.planes; ++plane)
    dns::find_outer_pressure(plane, metrics_.rho_faces, u[0], u[1], stream(0),
                             outer_pressure_.data() + extent_.wall_face(plane, 0));
}

// Takes what the pressure of the outer boundary makes of the gradient by itself from the fluxes
// that were posed: `scratch` is 0 at the cells and twice that pressure in the ghosts. No area there
// has a part along x.
void Fluid::subtract_outer_gradient(double dt, Field<double>& scratch) {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  double* through = balance_.row(0, n_rho);
  for (int plane = 0; plane < extent_.planes; ++plane) {
    for (const int j : {n_rho - 2, n_rho - 1}) std::fill_n(scratch.row(plane, j), n_theta, 0.0);
    for (int i = 0; i < n_theta; ++i)
      scratch.row(plane, n_rho)[i] = 2 * outer_pressure_[extent_.wall_face(plane, i)];
    scratch.wrap_theta(plane, n_rho - 2, n_rho + 1);
    gradient_flux_across_rho<double>(metrics_, plane, n_rho, scratch, nullptr, through);
    for (int i = 0; i < n_theta; ++i) flux_rho_.row(plane, n_rho)[i] -= dt * through[i];
    gradient_flux_across_theta<double>(metrics_, plane, n_rho - 1, scratch, nullptr, through);
    for (int i = 0; i <= n_theta; ++i) flux_theta_.row(plane, n_rho - 1)[i] -= dt * through[i];
    if (!span_.has_span()) continue;
    const double *s_x = metrics_.s_x.row(plane, n_rho - 1),
                 *volume = metrics_.volume.row(plane, n_rho - 1), *p = scratch.row(plane, n_rho);
    double* flux = change_xi_[0].row(plane, n_rho - 1);
    for (int i = 0; i < n_theta; ++i) flux[i] -= dt * volume[i] * s_x[i] * 0.5 * p[i];
  }
}

void Fluid::extend_pressure(Field<double>& p) const {
  extend_pressure(p, 1);
}

// With `share` of the pressure at the outer boundary.
void Fluid::extend_pressure(Field<double>& p, double share) const {
  for (int plane = 0; plane < extent_.planes; ++plane)
    dns::extend_pressure(plane, outer_pressure_.data() + extent_.wall_face(plane, 0), share, p);
}

// The integral of lap f over the cells of a plane, without what only its neighbours give: into
// balance_; and the flux along x over its derivative f_xi. f and f_xi with their ghosts.
void Fluid::balance_plane(int plane, const Field<double>& f, Field<double>* f_xi,
                          bool with_wall_flux) {
  gradient_balance(metrics_, plane, f, f_xi, with_wall_flux, balance_);
  if (f_xi) gradient_flux_along_x(metrics_, plane, f, *f_xi);
}

// (C . grad) f in a plane, into carried_, from f with its ghosts.
void Fluid::carry_plane(int plane, const Field<double>& f, const Field<double>* f_xi) {
  convection(plane, C_s_, C_t_, f, upwinding_, carried_);
  if (!f_xi) return;
  for (int j = 0; j < extent_.n_rho; ++j) {
    const double *u = guess_[2].row(plane, j), *xi = f_xi->row(plane, j);
    double* sum = carried_.row(0, j);
    for (int i = 0; i < extent_.n_theta; ++i) sum[i] += u[i] * xi[i];
  }
}

// Adds `factor` times the derivative of x_flux by x to packed cells.
void Fluid::add_x_flux(double factor, Field<double>& x_flux, double* packed) {
  if (!span_.has_span()) return;
  span_.differentiate(x_flux, x_flux);
  for_each_row(extent_, [&](int plane, int j) {
    const double* flux = x_flux.row(plane, j);
    for (int i = 0; i < extent_.n_theta; ++i) *packed++ += factor * flux[i];
  });
}

void Fluid::pressure_operator(const double* in, double* out) {
  Field<double>&f = change_[0], &f_xi = change_xi_[0];
  unpack(in, f);
  extend_pressure(f, 0);
  if (span_.has_span()) span_.differentiate(f, f_xi);
  double* to = out;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    balance_plane(plane, f, span_.has_span() ? &f_xi : nullptr, false);
    for (int j = 0; j < extent_.n_rho; ++j)
      to = std::copy_n(balance_.row(0, j), extent_.n_theta, to);
  }
  add_x_flux(1, f_xi, out);
}

void Fluid::invert_flat_pressure(const double* in, double* out) {
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

// For each component u: next_weight V u + V (C . grad) u - 1/Re (balance of u's gradient), u zero
// at the flag and in the stream.
void Fluid::velocity_operator(const Components& components, const double* in, double* out) {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const std::size_t cells = extent_.cells();
  const std::size_t first = components.first, end = components.end;
  const auto slope = [&](std::size_t c) {
    return change_varies_ ? &change_xi_[c - first] : nullptr;
  };
  for (std::size_t c = first; c < end; ++c) {
    Field<double>& f = change_[c - first];
    unpack(in + (c - first) * cells, f);
    for (int plane = 0; plane < extent_.planes; ++plane) {
      extend_to_wall(plane, no_velocity_.data(), f);
      f.wrap_theta(plane, -2, n_rho);
    }
  }
  for (std::size_t c = first; c < end; ++c) {  // where fluid enters the components are coupled
    Field<double>& f = change_[c - first];
    for (int plane = 0; plane < extent_.planes; ++plane) extend_change_outward(plane, c, false, f);
    if (change_varies_) span_.differentiate(f, change_xi_[c - first]);
  }
  for (int plane = 0; plane < extent_.planes; ++plane)
    for (std::size_t c = first; c < end; ++c) {
      Field<double>& f = change_[c - first];
      carry_plane(plane, f, slope(c));
      extend_change_outward(plane, c, true, f);
      balance_plane(plane, f, slope(c), true);
      const std::size_t offset =
          (c - first) * cells + static_cast<std::size_t>(plane) * extent_.cells_of_plane();
      const double* u = in + offset;
      double* result = out + offset;
      for (int j = 0; j < n_rho; ++j) {
        const double *balance = balance_.row(0, j), *carried = carried_.row(0, j);
        const double* volume = metrics_.volume.row(plane, j);
        for (int i = 0; i < n_theta; ++i, ++u, ++result)
          *result = volume[i] * (step_.D.next * *u + carried[i]) - balance[i] / parameters_.Re;
      }
    }
  if (!change_varies_) return;
  for (std::size_t c = first; c < end; ++c)
    add_x_flux(-1 / parameters_.Re, change_xi_[c - first], out + (c - first) * cells);
}

// u along the span needs no other component there.
void Fluid::extend_change_outward(int plane, std::size_t component, bool is_viscous,
                                  Field<double>& f) const {
  extend_outward(plane, is_viscous, f);
  if (!is_viscous) extend_inflow(plane, is_inflow_, change_, false, static_cast<int>(component), f);
  f.wrap_theta(plane, extent_.n_rho, extent_.n_rho + 2);
}

}  // namespace pennon::dns

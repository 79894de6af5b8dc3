#include "modes/global/equations/plane_equations.hpp"

#include <algorithm>
#include <array>

#include "dns/fluid/equations/continuity.hpp"
#include "dns/fluid/equations/grid_velocity.hpp"
#include "dns/fluid/equations/momentum.hpp"
#include "dns/fluid/equations/wall_forces.hpp"

namespace pennon::modes::global {

using dns::along_x, dns::along_y, dns::along_z;

template <class Scalar>
PlaneEquations<Scalar>::PlaneEquations(const OGrid& grid, const PlaneParameters& parameters,
                                       int components)
    : grid_(grid),
      parameters_(parameters),
      stream_(dns::uniform_stream(parameters.U)),
      extent_{1, grid.n_rho(), grid.n_theta()},
      metrics_(extent_, components > 2),
      no_slope_(extent_),
      is_inflow_(extent_.wall_faces(), false),
      grid_velocity_y_(extent_),
      grid_velocity_z_(extent_),
      wall_velocity_(static_cast<std::size_t>(components),
                     std::vector<Scalar>(extent_.wall_faces())),
      outer_pressure_(extent_.wall_faces()),
      wall_pressure_(extent_.wall_faces()),
      C_s_(extent_),
      C_t_(extent_),
      convected_(extent_),
      laplacian_(extent_),
      flux_rho_(extent_),
      flux_theta_(extent_),
      across_rho_(extent_),
      across_theta_(extent_),
      gradient_(static_cast<std::size_t>(components), Field<Scalar>(extent_)),
      friction_(static_cast<std::size_t>(components), std::vector<Scalar>(extent_.wall_faces())) {
  set_grid(no_slope_, nullptr);
}

template <class Scalar>
void PlaneEquations<Scalar>::set_grid(const Displacement<Scalar>& displacement,
                                      const Displacement<Scalar>* slope) {
  update_metrics(grid_, 0, displacement, slope ? slope : &no_slope_, metrics_);
}

template <class Scalar>
void PlaneEquations<Scalar>::set_grid_velocity(const Displacement<Scalar>& velocity) {
  dns::average_corners(0, velocity.y, grid_velocity_y_, wall_velocity_[along_y].data());
  dns::average_corners(0, velocity.z, grid_velocity_z_, wall_velocity_[along_z].data());
}

// R of a component and its friction on the wall.
template <class Scalar>
void PlaneEquations<Scalar>::momentum(std::size_t c, PlaneFlow<Scalar>& q,
                                      const Field<Scalar>* f_xi, Field<Scalar>& R) {
  Field<Scalar>& f = q.u[c];
  const double nu = 1 / parameters_.Re;
  const dns::OuterBoundary<Scalar> outer{metrics_.rho_faces, dns::outer_widening(grid_), is_inflow_,
                                         stream_};
  dns::extend_inward(0, wall_velocity_[c].data(), f);
  dns::extend_outward_for_convection(0, outer, q.u[along_y], q.u[along_z], c, f);
  dns::convective_derivative(0, C_s_, C_t_, has_span() ? &q.u[along_x] : nullptr, f, f_xi,
                             parameters_.upwinding, convected_);
  dns::extend_outward_for_friction(0, f);
  dns::integrated_laplacian<Scalar>(metrics_, 0, f, nullptr, true, laplacian_);
  for (int j = 0; j < extent_.n_rho; ++j) {
    const Scalar* push = gradient_[c].row(0, j);
    dns::momentum_residual<Scalar>(
        extent_.n_theta, {metrics_.volume.row(0, j), convected_.row(0, j), laplacian_.row(0, j)},
        nu, dns::no_term, [&](int i) { return push[i]; }, R.row(0, j));
  }
  dns::wall_friction_of<Scalar>(metrics_, 0, nu, f, nullptr, friction_[c].data());
}

// R of the pressure; gradient_ becomes v + dt' grad p.
template <class Scalar>
void PlaneEquations<Scalar>::continuity(const PlaneFlow<Scalar>& q, Field<Scalar>& R) {
  const double dt_of_pressure = parameters_.dt_of_pressure;
  for (std::size_t c = 0; c < q.u.size(); ++c) {
    for (int j = 0; j < extent_.n_rho; ++j)
      for (int i = 0; i < extent_.n_theta; ++i)
        gradient_[c].row(0, j)[i] =
            q.u[c].row(0, j)[i] + dt_of_pressure * gradient_[c].row(0, j)[i];
    gradient_[c].wrap_theta(0, 0, extent_.n_rho);
  }
  dns::velocity_flux(metrics_, 0, has_span() ? &gradient_[along_x] : nullptr, gradient_[along_y],
                     gradient_[along_z], flux_rho_, flux_theta_);
  dns::wall_flux(metrics_, 0, wall_velocity_, flux_rho_.row(0, 0));
  dns::outer_flux(metrics_, 0, gradient_, flux_rho_.row(0, extent_.n_rho));
  dns::gradient_flux<Scalar>(metrics_, 0, q.p, nullptr, across_rho_, across_theta_);
  dns::subtract_pressure_flux(0, dt_of_pressure, across_rho_, across_theta_, flux_rho_,
                              flux_theta_);
  std::ranges::fill(R.values(), Scalar(0));
  dns::add_divergence(0, flux_rho_, flux_theta_, R);
}

template <class Scalar>
void PlaneEquations<Scalar>::find_forces(const PlaneFlow<Scalar>& q) {
  const int n_theta = extent_.n_theta, segments = n_theta / 2;
  dns::wall_pressure_of(0, q.p, wall_pressure_.data());
  for (std::vector<Scalar>* force : {&forces_.x, &forces_.y, &forces_.z})
    force->assign(static_cast<std::size_t>(segments), Scalar(0));
  for (int s = 0; s < segments; ++s) {
    const Scalar jump = dns::pressure_jump(n_theta, s, wall_pressure_.data());
    const auto force = [&](std::size_t c) {
      return dns::sum_of_sides(n_theta, s, friction_[c].data()) +
             dns::area_along(metrics_.rho_faces, c).row(0, 0)[dns::upper_face(n_theta, s)] * jump;
    };
    const auto at = static_cast<std::size_t>(s);
    forces_.y[at] = force(along_y);
    forces_.z[at] = force(along_z);
    if (has_span()) forces_.x[at] = force(along_x);
  }
}

template <class Scalar>
void PlaneEquations<Scalar>::evaluate(PlaneFlow<Scalar>& q, const PlaneFlow<Scalar>* q_xi,
                                      PlaneFlow<Scalar>& R, PlaneFlow<Scalar>* X) {
  const Field<Scalar>* u_x = has_span() ? &q.u[along_x] : nullptr;
  for (int j = 0; j < extent_.n_rho; ++j)
    dns::convecting_velocity(metrics_, 0, j, u_x, q.u[along_y], q.u[along_z], grid_velocity_y_,
                             grid_velocity_z_, C_s_.row(0, j), C_t_.row(0, j));
  dns::find_outer_pressure(0, metrics_.rho_faces, q.u[along_y], q.u[along_z], stream_[along_y],
                           outer_pressure_.data());
  dns::extend_pressure(0, outer_pressure_.data(), 1, q.p);
  for (std::size_t c = 0; c < q.u.size(); ++c)
    dns::pressure_gradient(metrics_, 0, c, q.p, q_xi ? &q_xi->p : nullptr, gradient_[c]);
  for (std::size_t c = 0; c < q.u.size(); ++c) {
    momentum(c, q, q_xi ? &q_xi->u[c] : nullptr, R.u[c]);
    if (!X) continue;
    if (q_xi)
      X->u[c] = q_xi->u[c];
    else
      std::ranges::fill(X->u[c].values(), Scalar(0));
    dns::gradient_flux_along_x(metrics_, 0, q.u[c], X->u[c]);
    for (Scalar& flux : X->u[c].values()) flux /= parameters_.Re;
  }
  continuity(q, R.p);
  if (X)
    for (int j = 0; j < extent_.n_rho; ++j)
      for (int i = 0; i < extent_.n_theta; ++i)
        X->p.row(0, j)[i] = -metrics_.volume.row(0, j)[i] * q.u[along_x].row(0, j)[i];
  find_forces(q);
}

template class PlaneEquations<double>;
template class PlaneEquations<std::complex<double>>;

}  // namespace pennon::modes::global

#include "modes/global/equations/plane_equations.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "dns/fluid/equations/ghosts.hpp"
#include "dns/fluid/equations/wall_faces.hpp"

namespace pennon::modes::global {
namespace {

// The components of PlaneFlow::u.
constexpr int along_y = 0, along_z = 1, along_x = 2;

}  // namespace

template <class Scalar>
PlaneEquations<Scalar>::PlaneEquations(const OGrid& grid, const PlaneParameters& parameters,
                                       int components)
    : grid_(grid),
      parameters_(parameters),
      extent_{1, grid.n_rho(), grid.n_theta()},
      metrics_(extent_, components > 2),
      no_slope_(extent_),
      is_inflow_(extent_.wall_faces(), false),
      grid_velocity_y_(extent_),
      grid_velocity_z_(extent_),
      wall_velocity_(static_cast<std::size_t>(components),
                     std::vector<Scalar>(extent_.wall_faces())),
      outer_pressure_(extent_.wall_faces()),
      C_s_(extent_),
      C_t_(extent_),
      work_(extent_),
      flux_rho_(extent_),
      flux_theta_(extent_),
      across_rho_(extent_),
      across_theta_(extent_),
      gradient_(static_cast<std::size_t>(components), Field<Scalar>(extent_)),
      friction_(static_cast<std::size_t>(components), std::vector<Scalar>(extent_.wall_faces())) {
  set_grid(no_slope_, nullptr);
}

template <class Scalar>
double PlaneEquations<Scalar>::stream(int component) const {
  if (component == along_x) return parameters_.U;
  return component == along_y ? 1.0 : 0.0;
}

template <class Scalar>
void PlaneEquations<Scalar>::set_grid(const Displacement<Scalar>& displacement,
                                      const Displacement<Scalar>* slope) {
  update_metrics(grid_, 0, displacement, slope ? slope : &no_slope_, metrics_);
}

template <class Scalar>
void PlaneEquations<Scalar>::set_grid_velocity(const Displacement<Scalar>& velocity) {
  const auto average = [&](const Field<Scalar>& corners, Field<Scalar>& cells,
                           std::vector<Scalar>& wall) {
    for (int j = 0; j < extent_.n_rho; ++j) {
      const Scalar *below = corners.row(0, j), *above = corners.row(0, j + 1);
      for (int i = 0; i < extent_.n_theta; ++i)
        cells.row(0, j)[i] = 0.25 * (below[i] + below[i + 1] + above[i] + above[i + 1]);
    }
    const Scalar* corner = corners.row(0, 0);
    for (int i = 0; i < extent_.n_theta; ++i)
      wall[static_cast<std::size_t>(i)] = 0.5 * (corner[i] + corner[i + 1]);
  };
  average(velocity.y, grid_velocity_y_, wall_velocity_[along_y]);
  average(velocity.z, grid_velocity_z_, wall_velocity_[along_z]);
}

// R of a component but for the pressure, and its friction on the wall.
template <class Scalar>
void PlaneEquations<Scalar>::momentum(int component, PlaneFlow<Scalar>& q,
                                      const Field<Scalar>* f_xi, Field<Scalar>& R) {
  const auto c = static_cast<std::size_t>(component);
  Field<Scalar>& f = q.u[c];
  const dns::FaceMetrics<Scalar>& faces = metrics_.rho_faces;
  dns::extend_to_wall(0, wall_velocity_[c].data(), f);
  dns::extend_outward(0, false, f);
  const double widening = std::exp(grid_.rho_face_step(extent_.n_rho));  // of cosh(rho + i theta)
  const dns::Inflow<Scalar> inflow{is_inflow_,   faces,        widening,
                                   q.u[along_y], q.u[along_z], stream(along_y)};
  const std::array<const Field<Scalar>*, 3> areas = {&faces.area_y, &faces.area_z, nullptr};
  dns::reflect_inflow(0, inflow, areas[c], stream(component), f);
  f.wrap_theta(0, -2, extent_.n_rho + 2);
  dns::convection(0, C_s_, C_t_, f, parameters_.upwinding, work_);
  if (f_xi) {
    for (int j = 0; j < extent_.n_rho; ++j) {
      const Scalar *u = q.u[along_x].row(0, j), *xi = f_xi->row(0, j);
      for (int i = 0; i < extent_.n_theta; ++i) work_.row(0, j)[i] += u[i] * xi[i];
    }
  }
  for (int j = 0; j < extent_.n_rho; ++j)
    for (int i = 0; i < extent_.n_theta; ++i)
      R.row(0, j)[i] = metrics_.volume.row(0, j)[i] * work_.row(0, j)[i];
  dns::extend_outward(0, true, f);
  f.wrap_theta(0, extent_.n_rho, extent_.n_rho + 2);
  const double nu = 1 / parameters_.Re;
  dns::gradient_balance<Scalar>(metrics_, 0, f, nullptr, true, work_);
  for (int j = 0; j < extent_.n_rho; ++j)
    for (int i = 0; i < extent_.n_theta; ++i) R.row(0, j)[i] -= nu * work_.row(0, j)[i];
  dns::gradient_flux_across_rho<Scalar>(metrics_, 0, 0, f, nullptr, friction_[c].data());
  for (Scalar& force : friction_[c]) force *= nu;
}

// grad p, into gradient_ too; p with its ghosts.
template <class Scalar>
void PlaneEquations<Scalar>::add_pressure(const PlaneFlow<Scalar>& q, const Field<Scalar>* p_xi,
                                          PlaneFlow<Scalar>& R) {
  const std::array<const Field<Scalar>*, 3> s = {&metrics_.s_y, &metrics_.s_z, &metrics_.s_x},
                                            t = {&metrics_.t_y, &metrics_.t_z, &metrics_.t_x};
  for (std::size_t c = 0; c < q.u.size(); ++c) {
    dns::gradient_component(0, *s[c], *t[c], q.p, gradient_[c]);
    for (int j = 0; j < extent_.n_rho; ++j) {
      Scalar* gradient = gradient_[c].row(0, j);
      if (c == along_x && p_xi)
        for (int i = 0; i < extent_.n_theta; ++i) gradient[i] += p_xi->row(0, j)[i];
      for (int i = 0; i < extent_.n_theta; ++i)
        R.u[c].row(0, j)[i] += metrics_.volume.row(0, j)[i] * gradient[i];
    }
  }
}

template <class Scalar>
void PlaneEquations<Scalar>::continuity(const PlaneFlow<Scalar>& q, Field<Scalar>& R) {
  const int n_rho = extent_.n_rho, n_theta = extent_.n_theta;
  const double tau = parameters_.tau;
  const dns::FaceMetrics<Scalar>& faces = metrics_.rho_faces;
  const std::array<const Field<Scalar>*, 3> areas = {&faces.area_y, &faces.area_z, &faces.area_x};
  for (std::size_t c = 0; c < q.u.size(); ++c) {
    for (int j = 0; j < n_rho; ++j)
      for (int i = 0; i < n_theta; ++i)
        gradient_[c].row(0, j)[i] = q.u[c].row(0, j)[i] + tau * gradient_[c].row(0, j)[i];
    gradient_[c].wrap_theta(0, 0, n_rho);
  }
  dns::velocity_flux(metrics_, 0, has_span() ? &gradient_[along_x] : nullptr, gradient_[along_y],
                     gradient_[along_z], flux_rho_, flux_theta_);
  dns::gradient_flux<Scalar>(metrics_, 0, q.p, nullptr, across_rho_, across_theta_);
  Scalar *wall = flux_rho_.row(0, 0), *outer = flux_rho_.row(0, n_rho);
  for (int i = 0; i < n_theta; ++i) {
    wall[i] = outer[i] = 0;
    for (std::size_t c = 0; c < q.u.size(); ++c) {
      const Field<Scalar>& carried = gradient_[c];
      wall[i] += areas[c]->row(0, 0)[i] * wall_velocity_[c][static_cast<std::size_t>(i)];
      outer[i] += areas[c]->row(0, n_rho)[i] *
                  dns::outside_value(carried.row(0, n_rho - 1)[i], carried.row(0, n_rho - 2)[i]);
    }
    across_rho_.row(0, 0)[i] = 0;  // nothing passes through the flag
  }
  for (int j = 0; j <= n_rho; ++j) {
    for (int i = 0; i < n_theta; ++i) flux_rho_.row(0, j)[i] -= tau * across_rho_.row(0, j)[i];
    if (j == n_rho) break;
    for (int i = 0; i <= n_theta; ++i) flux_theta_.row(0, j)[i] -= tau * across_theta_.row(0, j)[i];
  }
  std::ranges::fill(R.values(), Scalar(0));
  dns::add_balance(0, flux_rho_, flux_theta_, R);
}

template <class Scalar>
void PlaneEquations<Scalar>::find_forces(const PlaneFlow<Scalar>& q) {
  const int segments = extent_.n_theta / 2;
  const auto pressure = [&](int face) {
    return dns::wall_value(q.p.row(0, 0)[face], q.p.row(0, 1)[face], q.p.row(0, 2)[face]);
  };
  for (std::vector<Scalar>* force : {&forces_.x, &forces_.y, &forces_.z})
    force->assign(static_cast<std::size_t>(segments), Scalar(0));
  for (int s = 0; s < segments; ++s) {
    const int upper = dns::upper_face(extent_.n_theta, s),
              lower = dns::lower_face(extent_.n_theta, s);
    const Scalar jump = pressure(lower) - pressure(upper);
    const auto force = [&](int c, const Field<Scalar>& area) {
      const std::vector<Scalar>& friction = friction_[static_cast<std::size_t>(c)];
      return friction[static_cast<std::size_t>(upper)] + friction[static_cast<std::size_t>(lower)] +
             area.row(0, 0)[upper] * jump;
    };
    const auto at = static_cast<std::size_t>(s);
    forces_.y[at] = force(along_y, metrics_.rho_faces.area_y);
    forces_.z[at] = force(along_z, metrics_.rho_faces.area_z);
    if (has_span()) forces_.x[at] = force(along_x, metrics_.rho_faces.area_x);
  }
}

template <class Scalar>
void PlaneEquations<Scalar>::evaluate(PlaneFlow<Scalar>& q, const PlaneFlow<Scalar>* q_xi,
                                      PlaneFlow<Scalar>& R, PlaneFlow<Scalar>* X) {
  const Field<Scalar>* u_x = has_span() ? &q.u[along_x] : nullptr;
  for (int j = 0; j < extent_.n_rho; ++j)
    dns::convecting_velocity(metrics_, 0, j, u_x, q.u[along_y], q.u[along_z], grid_velocity_y_,
                             grid_velocity_z_, C_s_.row(0, j), C_t_.row(0, j));
  dns::find_outer_pressure(0, metrics_.rho_faces, q.u[along_y], q.u[along_z], stream(along_y),
                           outer_pressure_.data());
  for (int c = 0; c < q.components(); ++c) {
    const auto k = static_cast<std::size_t>(c);
    momentum(c, q, q_xi ? &q_xi->u[k] : nullptr, R.u[k]);
    if (!X) continue;
    if (q_xi)
      X->u[k] = q_xi->u[k];
    else
      std::ranges::fill(X->u[k].values(), Scalar(0));
    dns::gradient_flux_along_x(metrics_, 0, q.u[k], X->u[k]);
    for (Scalar& flux : X->u[k].values()) flux /= parameters_.Re;
  }
  dns::extend_pressure(0, outer_pressure_.data(), 1, q.p);
  add_pressure(q, q_xi ? &q_xi->p : nullptr, R);
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

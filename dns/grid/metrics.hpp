/// What the fluid's equations need of the moving O-grid: areas, volumes and the derivatives of the
/// computational coordinates by the physical ones.
///
/// s and t count cells along rho and theta; x = xi. With the position r(xi, s, t) = (y, z) of a
/// plane's points,
///
///   J = y_s z_t - z_s y_t,   grad s = (z_t, -y_t)/J,   grad t = (-z_s, y_s)/J,
///   s_x = -(s_y y_xi + s_z z_xi),   t_x = -(t_y y_xi + t_z z_xi).
///
/// Two rules keep a uniform stream uniform and the edges of the flag exact:
/// - Area vectors come from the corners, so that those of a cell sum to zero; along x, they sum to
///   minus the change of its volume.
/// - grad s and grad t are taken pointwise, where they are used: those of the conformal grid by its
///   formula, those of the displacement by differences. (Forming them from areas and mean volumes
///   is wrong by a factor 20 at the face next to the trailing edge.)
/// On the conformal grid area . grad s is then a product of a function of rho and one of theta, and
/// area . grad t vanishes: the flat solver inverts these very operators.
///
/// Order of accuracy: 2. Precondition: no cell is folded.
#pragma once

#include <complex>

#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/field.hpp"
#include "dns/grid/o_grid.hpp"

namespace pennon::dns {

/// Of the faces across one coordinate, rho or theta. (area_x, area_y, area_z) is the area vector,
/// which points toward larger values of that coordinate. `along` is area . grad of the cell count
/// (s or t) along that coordinate, `across` area . grad of the other cell count.
template <class Scalar>
struct FaceMetrics {
  Field<Scalar> area_x, area_y, area_z, along, across;
};

template <class Scalar>
struct Metrics {
  FaceMetrics<Scalar> rho_faces, theta_faces;
  Field<Scalar> s_x, s_y, s_z, t_x, t_y, t_z, volume;  ///< at the cells; volume per unit of x
  bool has_span;  ///< without one the components along x are empty

  Metrics(const Extent& extent, bool with_span);
};

/// Fills the metrics of a plane. `slope_y`, `slope_z`: the derivatives of the corners' displacement
/// by xi, read if the metrics have a span.
template <class Scalar>
void update_metrics(const OGrid&, int plane, const Displacement<Scalar>& displacement,
                    const Field<Scalar>* slope_y, const Field<Scalar>* slope_z, Metrics<Scalar>&);
/// The same with both derivatives in one object.
template <class Scalar>
void update_metrics(const OGrid&, int plane, const Displacement<Scalar>& displacement,
                    const Displacement<Scalar>* slope, Metrics<Scalar>&);

/// Writes the corners (y, z) of a plane: n_rho + 1 rows of n_theta + 1, the last column repeats the
/// first.
void corners_of(const OGrid&, int plane, const Displacement<double>&, double* y, double* z);

extern template struct Metrics<double>;
extern template struct Metrics<std::complex<double>>;

}  // namespace pennon::dns

#include "dns/grid/metrics.hpp"

#include <algorithm>
#include <array>

namespace pennon::dns {
namespace {

// A vector (y, z) of the plane.
template <class Scalar>
struct Pair {
  Scalar y, z;

  friend Pair operator+(const Pair& a, const Pair& b) { return {a.y + b.y, a.z + b.z}; }
  friend Pair operator-(const Pair& a, const Pair& b) { return {a.y - b.y, a.z - b.z}; }
  friend Pair operator*(double factor, const Pair& a) { return {factor * a.y, factor * a.z}; }
  friend Scalar cross(const Pair& a, const Pair& b) { return a.y * b.z - a.z * b.y; }
  friend Scalar dot(const Pair& a, const Pair& b) { return a.y * b.y + a.z * b.z; }
};

// A row of corners.
template <class Scalar>
struct Row {
  const Scalar *y = nullptr, *z = nullptr;

  Row() = default;
  Row(const Field<Scalar>& of_y, const Field<Scalar>& of_z, int plane, int j)
      : y(of_y.row(plane, j)), z(of_z.row(plane, j)) {}
  Pair<Scalar> operator[](int i) const { return {y[i], z[i]}; }
};

// What the metrics of a face or a cell are made of: the derivatives of the position by the
// coordinate across the face and by the other one (in a cell by s and t), the face's edge, and the
// derivative by xi.
template <class Scalar>
struct Site {
  Pair<Scalar> along, across, edge, r_xi;
};

// sign: +1 across rho, -1 across theta, where the coordinates change places.
template <bool has_span, class Scalar, class SiteAt>
void write_faces(FaceMetrics<Scalar>& faces, int plane, int j, int count, double sign,
                 const SiteAt& site_at) {
  Scalar* area_x = has_span ? faces.area_x.row(plane, j) : nullptr;
  Scalar *area_y = faces.area_y.row(plane, j), *area_z = faces.area_z.row(plane, j);
  Scalar *along = faces.along.row(plane, j), *across = faces.across.row(plane, j);
#pragma GCC ivdep
  for (int i = 0; i < count; ++i) {
    const Site<Scalar> at = site_at(i);
    const Scalar inverse_J = sign / cross(at.along, at.across);
    Scalar c_along = dot(at.edge, at.across) * inverse_J;
    Scalar c_across = -dot(at.edge, at.along) * inverse_J;
    if constexpr (has_span) {
      const Scalar x = -sign * cross(at.r_xi, at.edge);
      // grad . r_xi of the two coordinates, times the sign.
      c_along -= sign * x * cross(at.r_xi, at.across) * inverse_J;
      c_across += sign * x * cross(at.r_xi, at.along) * inverse_J;
      area_x[i] = x;
    }
    area_y[i] = sign * at.edge.z;
    area_z[i] = -sign * at.edge.y;
    along[i] = c_along;
    across[i] = c_across;
  }
}

// Weights of the values at x0, x1, x2 in `step` times the derivative of their parabola at x.
// Without regard to how the steps grow, the derivative would be wrong by half their growth in the
// cells at the flag's edges, where all derivatives of the position vanish.
std::array<double, 3> derivative(double x, double x0, double x1, double x2, double step) {
  return {step * (2 * x - x1 - x2) / ((x0 - x1) * (x0 - x2)),
          step * (2 * x - x0 - x2) / ((x1 - x0) * (x1 - x2)),
          step * (2 * x - x0 - x1) / ((x2 - x0) * (x2 - x1))};
}

template <bool has_span, class Scalar>
struct Writer {
  const OGrid& grid;
  int plane;
  const Displacement<Scalar>& displacement;
  const Field<Scalar>*slope_y, *slope_z;
  Metrics<Scalar>& metrics;

  Row<Scalar> row(int j) const { return {displacement.y, displacement.z, plane, j}; }
  Row<Scalar> slope_row(int j) const {
    if constexpr (has_span) return {*slope_y, *slope_z, plane, j};
    return {};
  }

  void rho_faces(int j) const {
    const int n = grid.n_rho();
    const RhoTable& rho = grid.along_rho();
    const ThetaTable& theta = grid.along_theta();
    const auto at_j = static_cast<std::size_t>(j);
    const double cosh = rho.cosh[at_j] / 2, sinh = rho.sinh[at_j] / 2, step = rho.face_step[at_j];
    const double *cos = theta.cos_centre.data(), *sin = theta.sin_centre.data();
    const double *theta_step = theta.step.data(), *half_sine = theta.sin_half_step.data();
    const int middle = std::clamp(j, 1, n - 1);
    const Row<Scalar> d0 = row(middle - 1), d1 = row(middle), d2 = row(middle + 1);
    const std::array<double, 3> w =
        derivative(grid.rho(j), grid.rho(middle - 1), grid.rho(middle), grid.rho(middle + 1), step);
    const Row<Scalar> d = row(j), d_xi = slope_row(j);
    write_faces<has_span>(metrics.rho_faces, plane, j, grid.n_theta(), 1, [=](int i) {
      const Pair<Scalar> Z{sinh * cos[i], cosh * sin[i]}, iZ{-cosh * sin[i], sinh * cos[i]};
      const Pair<Scalar> d_s = 0.5 * (w[0] * (d0[i] + d0[i + 1]) + w[1] * (d1[i] + d1[i + 1]) +
                                      w[2] * (d2[i] + d2[i + 1]));
      const Pair<Scalar> d_t = d[i + 1] - d[i];
      Site<Scalar> at{step * Z + d_s, theta_step[i] * iZ + d_t, 2 * half_sine[i] * iZ + d_t, {}};
      if constexpr (has_span) at.r_xi = 0.5 * (d_xi[i] + d_xi[i + 1]);
      return at;
    });
  }

  void theta_faces(int j) const {
    const RhoTable& rho = grid.along_rho();
    const ThetaTable& theta = grid.along_theta();
    const auto at_j = static_cast<std::size_t>(j);
    const double cosh = rho.cosh_centre[at_j] / 2, sinh = rho.sinh_centre[at_j] / 2;
    const double step = rho.step[at_j], half_step = 2 * rho.sinh_half_step[at_j];
    const double *cos = theta.cos.data(), *sin = theta.sin.data();
    const double* theta_step = theta.face_step.data();
    const Row<Scalar> d0 = row(j), d1 = row(j + 1), xi0 = slope_row(j), xi1 = slope_row(j + 1);
    write_faces<has_span>(metrics.theta_faces, plane, j, grid.n_theta() + 1, -1, [=](int i) {
      const Pair<Scalar> Z{sinh * cos[i], cosh * sin[i]}, iZ{-cosh * sin[i], sinh * cos[i]};
      const Pair<Scalar> d_s = d1[i] - d0[i];
      const Pair<Scalar> d_t = 0.25 * (d0[i + 1] + d1[i + 1] - d0[i - 1] - d1[i - 1]);
      Site<Scalar> at{theta_step[i] * iZ + d_t, step * Z + d_s, half_step * Z + d_s, {}};
      if constexpr (has_span) at.r_xi = 0.5 * (xi0[i] + xi1[i]);
      return at;
    });
  }

  void cells(int j) const {
    const RhoTable& rho = grid.along_rho();
    const ThetaTable& theta = grid.along_theta();
    const auto at_j = static_cast<std::size_t>(j);
    const double cosh = rho.cosh_centre[at_j] / 2, sinh = rho.sinh_centre[at_j] / 2;
    const double step = rho.step[at_j];
    const double cosh_half = 2 * rho.cosh_half_step[at_j], sinh_half = 2 * rho.sinh_half_step[at_j];
    const double *cos = theta.cos_centre.data(), *sin = theta.sin_centre.data();
    const double* theta_step = theta.step.data();
    const double *cos_half = theta.cos_half_step.data(), *sin_half = theta.sin_half_step.data();
    const Row<Scalar> d0 = row(j), d1 = row(j + 1), xi0 = slope_row(j), xi1 = slope_row(j + 1);
    Scalar *s_y = metrics.s_y.row(plane, j), *s_z = metrics.s_z.row(plane, j);
    Scalar *t_y = metrics.t_y.row(plane, j), *t_z = metrics.t_z.row(plane, j);
    Scalar* s_x = has_span ? metrics.s_x.row(plane, j) : nullptr;
    Scalar* t_x = has_span ? metrics.t_x.row(plane, j) : nullptr;
    Scalar* volume = metrics.volume.row(plane, j);
    const int count = grid.n_theta();
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
      const double Z_y = sinh * cos[i], Z_z = cosh * sin[i];
      const Pair<Scalar> d_a = d1[i + 1] - d0[i], d_b = d0[i + 1] - d1[i];
      const Pair<Scalar> r_s = Pair<Scalar>{step * Z_y, step * Z_z} + 0.5 * (d_a - d_b);
      const Pair<Scalar> r_t =
          Pair<Scalar>{-theta_step[i] * Z_z, theta_step[i] * Z_y} + 0.5 * (d_a + d_b);
      const Scalar inverse_J = 1.0 / cross(r_s, r_t);
      s_y[i] = r_t.z * inverse_J;
      s_z[i] = -r_t.y * inverse_J;
      t_y[i] = -r_s.z * inverse_J;
      t_z[i] = r_s.y * inverse_J;
      if constexpr (has_span) {
        const Pair<Scalar> r_xi = 0.25 * (xi0[i] + xi1[i] + xi0[i + 1] + xi1[i + 1]);
        s_x[i] = -cross(r_xi, r_t) * inverse_J;
        t_x[i] = cross(r_xi, r_s) * inverse_J;
      }
      // The area between the corners is half the cross product of the diagonals a and b. That at
      // rest is ... sinh(d_rho) sin(d_theta); the product that the flat solver inverts, equal to
      // second order, stands for it. The difference does not change along x.
      const double real = sinh_half * cos_half[i], imag = cosh_half * sin_half[i];
      const Pair<Scalar> a{Z_y * real - Z_z * imag, Z_y * imag + Z_z * real};
      const Pair<Scalar> b{-Z_y * real - Z_z * imag, Z_y * imag - Z_z * real};
      const double at_rest = (Z_y * Z_y + Z_z * Z_z) * 2 * sinh_half * sin_half[i];
      volume[i] = at_rest + 0.5 * (cross(a, d_b) + cross(d_a, b) + cross(d_a, d_b));
    }
  }

  void write() const {
    for (int j = 0; j <= grid.n_rho(); ++j) {
      rho_faces(j);
      if (j == grid.n_rho()) continue;
      theta_faces(j);
      cells(j);
    }
  }
};

}  // namespace

template <class Scalar>
Metrics<Scalar>::Metrics(const Extent& extent, bool with_span)
    : s_y(extent), s_z(extent), t_y(extent), t_z(extent), volume(extent), has_span(with_span) {
  for (FaceMetrics<Scalar>* faces : {&rho_faces, &theta_faces}) {
    for (Field<Scalar>* field : {&faces->area_y, &faces->area_z, &faces->along, &faces->across})
      *field = Field<Scalar>(extent);
    if (with_span) faces->area_x = Field<Scalar>(extent);
  }
  if (with_span) {
    s_x = Field<Scalar>(extent);
    t_x = Field<Scalar>(extent);
  }
}

template <class Scalar>
void update_metrics(const OGrid& grid, int plane, const Displacement<Scalar>& displacement,
                    const Field<Scalar>* slope_y, const Field<Scalar>* slope_z,
                    Metrics<Scalar>& metrics) {
  if (metrics.has_span)
    Writer<true, Scalar>{grid, plane, displacement, slope_y, slope_z, metrics}.write();
  else
    Writer<false, Scalar>{grid, plane, displacement, slope_y, slope_z, metrics}.write();
}

template <class Scalar>
void update_metrics(const OGrid& grid, int plane, const Displacement<Scalar>& displacement,
                    const Displacement<Scalar>* slope, Metrics<Scalar>& metrics) {
  update_metrics(grid, plane, displacement, slope ? &slope->y : nullptr,
                 slope ? &slope->z : nullptr, metrics);
}

void corners_of(const OGrid& grid, int plane, const Displacement<double>& displacement, double* y,
                double* z) {
  for (int j = 0; j <= grid.n_rho(); ++j)
    for (int i = 0; i <= grid.n_theta(); ++i) {
      const std::complex<double> rest = OGrid::place(grid.rho(j), grid.theta(i));
      *y++ = rest.real() + displacement.y.row(plane, j)[i];
      *z++ = rest.imag() + displacement.z.row(plane, j)[i];
    }
}

template struct Metrics<double>;
template struct Metrics<std::complex<double>>;
template void update_metrics(const OGrid&, int, const Displacement<double>&, const Field<double>*,
                             const Field<double>*, Metrics<double>&);
template void update_metrics(const OGrid&, int, const Displacement<double>&,
                             const Displacement<double>*, Metrics<double>&);
template void update_metrics(const OGrid&, int, const Displacement<std::complex<double>>&,
                             const Displacement<std::complex<double>>*,
                             Metrics<std::complex<double>>&);

}  // namespace pennon::dns

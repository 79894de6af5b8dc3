#include "dns/metrics.hpp"

#include <cmath>

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
};

template <class Scalar>
Pair<Scalar> pair_of(const std::complex<double>& number) {
  return {Scalar(number.real()), Scalar(number.imag())};
}

// The corners' vectors of a plane by row and column.
template <class Scalar>
class Corners {
 public:
  Corners(const Displacement<Scalar>& displacement, int plane)
      : displacement_(displacement), plane_(plane) {}
  Pair<Scalar> operator()(int j, int i) const {
    return {displacement_.y.row(plane_, j)[i], displacement_.z.row(plane_, j)[i]};
  }

 private:
  const Displacement<Scalar>& displacement_;
  int plane_;
};

// Gradients of s and t from the derivatives of the position.
template <class Scalar>
struct Gradients {
  Pair<Scalar> s, t;

  Gradients(const Pair<Scalar>& r_s, const Pair<Scalar>& r_t) {
    const Scalar inverse_J = Scalar(1) / cross(r_s, r_t);
    s = {r_t.z * inverse_J, -r_t.y * inverse_J};
    t = {-r_s.z * inverse_J, r_s.y * inverse_J};
  }
};

template <class Scalar>
Scalar dot(const Pair<Scalar>& a, const Pair<Scalar>& b) {
  return a.y * b.y + a.z * b.z;
}

template <class Scalar>
struct Writer {
  const OGrid& grid;
  int plane;
  Corners<Scalar> d;
  const Displacement<Scalar>* slope;
  Metrics<Scalar>& metrics;

  // edge: the face's, along the other coordinate; sign: +1 across rho, -1 across theta.
  void face(FaceMetrics<Scalar>& faces, int j, int i, const Pair<Scalar>& edge, double sign,
            const Pair<Scalar>& along, const Pair<Scalar>& across, const Pair<Scalar>& r_xi) const {
    const Pair<Scalar> area{sign * edge.z, -sign * edge.y};
    Scalar c_along = dot(area, along), c_across = dot(area, across);
    if (metrics.has_span) {
      const Scalar area_x = -dot(area, r_xi);
      c_along -= area_x * dot(along, r_xi);
      c_across -= area_x * dot(across, r_xi);
      faces.area_x.row(plane, j)[i] = area_x;
    }
    faces.area_y.row(plane, j)[i] = area.y;
    faces.area_z.row(plane, j)[i] = area.z;
    faces.along.row(plane, j)[i] = c_along;
    faces.across.row(plane, j)[i] = c_across;
  }

  Pair<Scalar> mean_slope(int j, int i, int j2, int i2) const {
    if (!metrics.has_span) return {Scalar(0), Scalar(0)};
    const Corners<Scalar> r_xi(*slope, plane);
    return 0.5 * (r_xi(j, i) + r_xi(j2, i2));
  }

  void rho_face(int j, int i) const {
    const double theta = grid.theta_centre(i);
    const std::complex<double> Z = OGrid::slope(grid.rho(j), theta);
    constexpr std::complex<double> I(0, 1);
    const auto along_rho = [&](int row) { return 0.5 * (d(row, i) + d(row, i + 1)); };
    const int n = grid.n_rho();
    Pair<Scalar> d_s;
    if (j == 0)
      d_s = 0.5 * (4.0 * along_rho(1) - 3.0 * along_rho(0) - along_rho(2));
    else if (j == n)
      d_s = 0.5 * (3.0 * along_rho(n) - 4.0 * along_rho(n - 1) + along_rho(n - 2));
    else
      d_s = 0.5 * (along_rho(j + 1) - along_rho(j - 1));
    const Pair<Scalar> d_t = d(j, i + 1) - d(j, i);
    const Gradients<Scalar> gradients(pair_of<Scalar>(Z * grid.rho_face_step(j)) + d_s,
                                      pair_of<Scalar>(I * Z * grid.theta_step(i)) + d_t);
    const Pair<Scalar> edge = pair_of<Scalar>(2.0 * I * Z * std::sin(grid.theta_step(i) / 2)) + d_t;
    face(metrics.rho_faces, j, i, edge, 1, gradients.s, gradients.t, mean_slope(j, i, j, i + 1));
  }

  void theta_face(int j, int i) const {
    const std::complex<double> Z = OGrid::slope(grid.rho_centre(j), grid.theta(i));
    constexpr std::complex<double> I(0, 1);
    const Pair<Scalar> d_s = d(j + 1, i) - d(j, i);
    const Pair<Scalar> d_t = 0.25 * (d(j, i + 1) + d(j + 1, i + 1) - d(j, i - 1) - d(j + 1, i - 1));
    const Gradients<Scalar> gradients(pair_of<Scalar>(Z * grid.rho_step(j)) + d_s,
                                      pair_of<Scalar>(I * Z * grid.theta_face_step(i)) + d_t);
    const Pair<Scalar> edge = pair_of<Scalar>(2.0 * Z * std::sinh(grid.rho_step(j) / 2)) + d_s;
    face(metrics.theta_faces, j, i, edge, -1, gradients.t, gradients.s, mean_slope(j, i, j + 1, i));
  }

  void cell(int j, int i) const {
    const double rho = grid.rho_centre(j), theta = grid.theta_centre(i);
    const double d_rho = grid.rho_step(j), d_theta = grid.theta_step(i);
    const std::complex<double> Z = OGrid::slope(rho, theta);
    constexpr std::complex<double> I(0, 1);
    const Pair<Scalar> d_s = 0.5 * (d(j + 1, i) + d(j + 1, i + 1) - d(j, i) - d(j, i + 1));
    const Pair<Scalar> d_t = 0.5 * (d(j, i + 1) + d(j + 1, i + 1) - d(j, i) - d(j + 1, i));
    const Gradients<Scalar> gradients(pair_of<Scalar>(Z * d_rho) + d_s,
                                      pair_of<Scalar>(I * Z * d_theta) + d_t);
    metrics.s_y.row(plane, j)[i] = gradients.s.y;
    metrics.s_z.row(plane, j)[i] = gradients.s.z;
    metrics.t_y.row(plane, j)[i] = gradients.t.y;
    metrics.t_z.row(plane, j)[i] = gradients.t.z;
    if (metrics.has_span) {
      const Pair<Scalar> r_xi =
          0.5 * (mean_slope(j, i, j + 1, i) + mean_slope(j, i + 1, j + 1, i + 1));
      metrics.s_x.row(plane, j)[i] = -dot(gradients.s, r_xi);
      metrics.t_x.row(plane, j)[i] = -dot(gradients.t, r_xi);
    }
    // The area between the corners is half the cross product of the diagonals. That at rest is
    // ... sinh(d_rho) sin(d_theta); the product that the flat solver inverts, equal to second
    // order, stands for it. The difference does not change along x.
    const std::complex<double> half_step(d_rho / 2, d_theta / 2);
    const Pair<Scalar> a = pair_of<Scalar>(2.0 * Z * std::sinh(half_step));
    const Pair<Scalar> b = pair_of<Scalar>(-2.0 * Z * std::sinh(std::conj(half_step)));
    const Pair<Scalar> d_a = d(j + 1, i + 1) - d(j, i), d_b = d(j, i + 1) - d(j + 1, i);
    const double at_rest = 4 * std::norm(Z) * std::sinh(d_rho / 2) * std::sin(d_theta / 2);
    metrics.volume.row(plane, j)[i] =
        at_rest + 0.5 * (cross(a, d_b) + cross(d_a, b) + cross(d_a, d_b));
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
                    const Displacement<Scalar>* slope, Metrics<Scalar>& metrics) {
  const Writer<Scalar> writer{grid, plane, {displacement, plane}, slope, metrics};
  for (int j = 0; j <= grid.n_rho(); ++j) {
    for (int i = 0; i < grid.n_theta(); ++i) writer.rho_face(j, i);
    if (j == grid.n_rho()) continue;
    for (int i = 0; i <= grid.n_theta(); ++i) writer.theta_face(j, i);
    for (int i = 0; i < grid.n_theta(); ++i) writer.cell(j, i);
  }
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
template void update_metrics(const OGrid&, int, const Displacement<double>&,
                             const Displacement<double>*, Metrics<double>&);
template void update_metrics(const OGrid&, int, const Displacement<std::complex<double>>&,
                             const Displacement<std::complex<double>>*,
                             Metrics<std::complex<double>>&);

}  // namespace pennon::dns

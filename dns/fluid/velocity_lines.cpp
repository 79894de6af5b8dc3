#include "dns/fluid/velocity_lines.hpp"

#include <algorithm>
#include <cmath>

#include "dns/grid/packing.hpp"

namespace pennon::dns {

VelocityLines::VelocityLines(const Extent& extent)
    : lower_(extent), pivot_(extent), upper_(extent) {}

void VelocityLines::prepare(const Metrics<double>& metrics, const Field<double>& C_s,
                            const Field<double>& C_t, double weight, double nu) {
  const Extent& extent = lower_.extent();
  const int n_rho = extent.n_rho, n_theta = extent.n_theta;
  for_each_row(extent, [&](int plane, int j) {
    const double* volume = metrics.volume.row(plane, j);
    const double *s = C_s.row(plane, j), *t = C_t.row(plane, j);
    const double *below = metrics.rho_faces.along.row(plane, j),
                 *above = metrics.rho_faces.along.row(plane, j + 1),
                 *theta = metrics.theta_faces.along.row(plane, j);
    double *lower = lower_.row(plane, j), *pivot = pivot_.row(plane, j),
           *upper = upper_.row(plane, j);
    const double* upper_below = upper_.row(plane, j - 1);
    for (int i = 0; i < n_theta; ++i) {
      const double outer = j + 1 < n_rho ? above[i] : 0.0;
      double diagonal = volume[i] * (weight + std::abs(s[i]) + std::abs(t[i])) +
                        nu * (below[i] + outer + theta[i] + theta[i + 1]);
      lower[i] = -nu * below[i] - volume[i] * std::max(s[i], 0.0);
      upper[i] = -nu * above[i] + volume[i] * std::min(s[i], 0.0);
      if (j == 0) {  // the wall's one-sided difference
        diagonal += 2 * nu * below[i];
        upper[i] -= nu * below[i] / 3;
      } else {
        diagonal -= lower[i] * upper_below[i];
      }
      pivot[i] = 1 / diagonal;
      upper[i] *= pivot[i];
    }
  });
}

void VelocityLines::invert(std::size_t components, const double* in, double* out) const {
  const Extent& extent = lower_.extent();
  const int n_rho = extent.n_rho, n_theta = extent.n_theta;
  for (int plane = 0; plane < extent.planes; ++plane)
    for (std::size_t c = 0; c < components; ++c) {
      const std::size_t first =
          c * extent.cells() + static_cast<std::size_t>(plane) * extent.cells_of_plane();
      const auto row = [&](auto* values, int j) {
        return values + first + static_cast<std::size_t>(j) * static_cast<std::size_t>(n_theta);
      };
      for (int j = 0; j < n_rho; ++j) {
        const double *f = row(in, j), *lower = lower_.row(plane, j);
        const double* pivot = pivot_.row(plane, j);
        double* u = row(out, j);
        if (j == 0)
          for (int i = 0; i < n_theta; ++i) u[i] = f[i] * pivot[i];
        else
          for (int i = 0; i < n_theta; ++i)
            u[i] = (f[i] - lower[i] * row(out, j - 1)[i]) * pivot[i];
      }
      for (int j = n_rho - 2; j >= 0; --j) {
        const double *upper = upper_.row(plane, j), *next = row(out, j + 1);
        double* u = row(out, j);
        for (int i = 0; i < n_theta; ++i) u[i] -= upper[i] * next[i];
      }
    }
}

}  // namespace pennon::dns

#include "dns/fluid/moving_grid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <utility>

#include "common/parallel/ranks.hpp"
#include "dns/fluid/equations/component.hpp"
#include "dns/fluid/equations/grid_velocity.hpp"

namespace pennon::dns {

MovingGrid::MovingGrid(const OGrid& grid, const Span& span, const FluidTolerances& tolerances,
                       FluidScratch& scratch)
    : grid_(grid),
      span_(span),
      tolerances_(tolerances),
      extent_{span.local_planes(), grid.n_rho(), grid.n_theta()},
      scratch_(scratch),
      elliptic_(grid),
      metrics_(extent_, span.has_span()),
      velocity_y_(extent_),
      velocity_z_(extent_) {}

void MovingGrid::fit(const WallShape& wall, double t, Displacement<double>& grid) {
  bool fits = true;
  for (int plane = 0; plane < extent_.planes; ++plane) {
    const std::size_t first = extent_.wall_face(plane, 0);
    constexpr int most_passes = 300;
    const EllipticGridSummary found = elliptic_.follow(
        plane, wall.y.data() + first, wall.z.data() + first, grid, tolerances_.grid, most_passes);
    fits = fits && found.least_area > 0;
  }
  if (ranks::any(!fits)) fail_at(t, "no grid fits the flag: it bends too sharply for dns.n_theta");
}

void MovingGrid::move(const FluidStep& step, const WallShape& wall, FluidState& state,
                      FluidStepSummary& summary) {
  std::rotate(state.grid.begin(), state.grid.end() - 1, state.grid.end());
  Displacement<double>&next = state.grid[0], &last = state.grid[1], &before = state.grid[2];
  combine(step.D.guess_last, last.y, step.D.guess_before, before.y, next.y);
  combine(step.D.guess_last, last.z, step.D.guess_before, before.z, next.z);
  std::array<double, 4> fold{};  // whether there is one, and its x, y, z
  for (int plane = 0; plane < extent_.planes; ++plane) {
    const std::size_t first = extent_.wall_face(plane, 0);
    const EllipticGridSummary found =
        elliptic_.follow(plane, wall.y.data() + first, wall.z.data() + first, next,
                         tolerances_.grid, tolerances_.most_grid_passes);
    summary.grid_passes = std::max(summary.grid_passes, found.passes);
    summary.least_area = std::min(summary.least_area, found.least_area);
    summary.largest_wall_area =
        std::max(summary.largest_wall_area, elliptic_.largest_wall_area(plane, next));
    if (!(found.least_area > 0)) fold = {1, span_.x(plane), found.worst_y, found.worst_z};
  }
  if (!ranks::any(fold[0] > 0)) return;
  const std::vector<double> folds = ranks::gather_all(fold);
  for (std::size_t k = 0; k < folds.size(); k += fold.size())
    if (folds[k] > 0)
      fail_at(step.t,
              fmt::format("the grid folds at ({:.4g}, {:.4g}, {:.4g}): the flag bends too sharply "
                          "for dns.n_theta = {}, or moves too far in a step of dns.dt",
                          folds[k + 1], folds[k + 2], folds[k + 3], extent_.n_theta));
}

void MovingGrid::find_velocity(const FluidStep& step, const FluidState& state,
                               WallVelocity& wall_velocity) {
  const FieldLease corners = scratch_.fields.lease("velocity of the corners");
  const auto velocity_of = [&](Field<double> Displacement<double>::*direction,
                               Field<double>& at_cells, std::vector<double>& at_wall) {
    const Field<double>&d0 = state.grid[0].*direction, &d1 = state.grid[1].*direction,
          &d2 = state.grid[2].*direction;
    for (int plane = 0; plane < extent_.planes; ++plane) {
      for (int j = 0; j <= extent_.n_rho; ++j) {
        const double *a = d0.row(plane, j), *b = d1.row(plane, j), *c = d2.row(plane, j);
        double* corner = corners->row(plane, j);
        for (int i = 0; i <= extent_.n_theta; ++i) corner[i] = step.D.derivative(a[i], b[i], c[i]);
      }
      average_corners(plane, *corners, at_cells, at_wall.data() + extent_.wall_face(plane, 0));
    }
  };
  velocity_of(&Displacement<double>::y, velocity_y_, wall_velocity[along_y]);
  velocity_of(&Displacement<double>::z, velocity_z_, wall_velocity[along_z]);
}

void MovingGrid::update_metrics(const Displacement<double>& displacement) {
  FieldLease slope_y, slope_z;
  if (span_.has_span()) {
    slope_y = scratch_.fields.lease("slope of the corners' y");
    slope_z = scratch_.fields.lease("slope of the corners' z");
    span_.differentiate(displacement.y, *slope_y);
    span_.differentiate(displacement.z, *slope_z);
  }
  for (int plane = 0; plane < extent_.planes; ++plane)
    dns::update_metrics<double>(grid_, plane, displacement, slope_y.get(), slope_z.get(), metrics_);
}

std::array<double, 2> MovingGrid::centre(const Displacement<double>& displacement, int plane, int j,
                                         int i) const {
  const std::complex<double> rest = OGrid::place(grid_.rho_centre(j), grid_.theta_centre(i));
  const auto mean = [&](const Field<double>& d) {
    const double *below = d.row(plane, j) + i, *above = d.row(plane, j + 1) + i;
    return 0.25 * (below[0] + below[1] + above[0] + above[1]);
  };
  return {rest.real() + mean(displacement.y), rest.imag() + mean(displacement.z)};
}

std::array<double, 2> MovingGrid::wall_centre(const Displacement<double>& displacement, int plane,
                                              int i) const {
  const std::complex<double> rest = OGrid::place(0, grid_.theta_centre(i));
  const double *y = displacement.y.row(plane, 0) + i, *z = displacement.z.row(plane, 0) + i;
  return {rest.real() + 0.5 * (y[0] + y[1]), rest.imag() + 0.5 * (z[0] + z[1])};
}

}  // namespace pennon::dns

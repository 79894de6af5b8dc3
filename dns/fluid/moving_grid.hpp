/// The grid about the flag in motion: its corners at the end of a step, its metrics, and the
/// velocity v_g with which it gets there by the backward difference of the step.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "dns/fluid/parameters.hpp"
#include "dns/fluid/state.hpp"
#include "dns/fluid/step.hpp"
#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/metrics.hpp"
#include "dns/grid/o_grid.hpp"
#include "dns/grid/span.hpp"

namespace pennon::dns {

/// Where the wall is: the displacement of the flag from rest at the corners of the grid, for each
/// plane n_theta numbers (Displacement's row 0).
struct WallShape {
  std::vector<double> y, z;
};

class MovingGrid {
 public:
  MovingGrid(const OGrid&, const Span&, const FluidTolerances&, FluidScratch&);

  /// Solves for the corners about the wall at time t; what `grid` holds is the first guess. Throws
  /// SolverError where no grid fits.
  void fit(const WallShape&, double t, Displacement<double>& grid);

  /// Moves the corners from those of the last two steps to the wall at the end of the step, and
  /// writes passes and areas into the summary. Throws SolverError with time and place where the
  /// grid folds.
  void move(const FluidStep&, const WallShape&, FluidState&, FluidStepSummary&);

  /// v_g at the cells, and the part of the wall's velocity in the plane that the corners give.
  void find_velocity(const FluidStep&, const FluidState&, WallVelocity&);

  /// The metrics of these corners.
  void update_metrics(const Displacement<double>&);

  const Metrics<double>& metrics() const { return metrics_; }
  const Field<double>& velocity_y() const { return velocity_y_; }
  const Field<double>& velocity_z() const { return velocity_z_; }

  /// The middle (y, z) of a cell, and of a face of the wall.
  std::array<double, 2> centre(const Displacement<double>&, int plane, int j, int i) const;
  std::array<double, 2> wall_centre(const Displacement<double>&, int plane, int i) const;

 private:
  const OGrid& grid_;
  const Span& span_;
  const FluidTolerances& tolerances_;
  Extent extent_;
  FluidScratch& scratch_;
  EllipticGrid elliptic_;
  Metrics<double> metrics_;
  Field<double> velocity_y_, velocity_z_;
};

}  // namespace pennon::dns

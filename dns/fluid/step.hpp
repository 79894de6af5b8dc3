/// What the parts of a step of the fluid share: its time step, the stream, work arrays, and what it
/// reports.
#pragma once

#include <array>
#include <functional>
#include <string>
#include <vector>

#include "dns/grid/field.hpp"
#include "dns/grid/scratch.hpp"
#include "dns/numerics/backward_difference.hpp"

namespace pennon::dns {

/// A step from t - dt to t.
struct FluidStep {
  BackwardDifference D{1, 0};  ///< D_t of fluid.hpp
  double t = 0, dt = 1;
  std::array<double, 3> stream{};  ///< the stream's velocity at t, by component
  std::array<double, 3> drive{};   ///< its rate of change by D: a force on all of the fluid alike

  /// dt' of docs/theory/fluid.md, 2/3 dt in equal steps: the time over which the gradient of the
  /// new pressure changes the velocity.
  double dt_of_pressure() const { return 1 / D.next; }
};

/// Wall seconds of a step by phase.
struct FluidStepTimes {
  double grid = 0, metrics = 0, prediction = 0, projection = 0;
};

struct FluidStepSummary {
  int pressure_iterations = 0;
  /// (v, w) and u are solved for apart: the larger of the two numbers of iterations.
  int velocity_iterations = 0;
  int grid_passes = 0;           ///< of the elliptic grid, the largest number in any plane
  double least_area = 1;         ///< the least of all cells, over its area at rest
  double largest_wall_area = 1;  ///< the largest of the cells at the flag, over its area at rest
  double CFL = 0;                ///< largest Courant number, the sum of those of the directions
  FluidStepTimes seconds;
};

/// A body force and wall velocities given by place and time, along x, y, z, for manufactured
/// solutions. An empty function adds nothing: without wall_velocity the wall moves as its shape
/// does.
struct Manufactured {
  using Function = std::function<std::array<double, 3>(double t, double x, double y, double z)>;
  Function force, wall_velocity;
};

/// The velocity of the wall's faces by component, n_theta numbers for each plane.
using WallVelocity = std::vector<std::vector<double>>;

/// Work arrays of the fluid: fields of all planes of this rank, fields of one plane, and packed
/// vectors of two components.
struct FluidScratch {
  Scratch<Field<double>> fields, planes;
  Scratch<std::vector<double>> vectors;

  explicit FluidScratch(const Extent& extent)
      : fields([extent] { return Field<double>(extent); }),
        planes([extent] {
          return Field<double>(Extent{1, extent.n_rho, extent.n_theta});
        }),
        vectors([extent] { return std::vector<double>(2 * extent.cells()); }) {}
};

using FieldLease = Scratch<Field<double>>::Lease;
using VectorLease = Scratch<std::vector<double>>::Lease;

/// sum = a f + b g, ghosts too.
void combine(double a, const Field<double>& f, double b, const Field<double>& g,
             Field<double>& sum);

/// Throws SolverError with the time in front.
[[noreturn]] void fail_at(double t, const std::string& what);

}  // namespace pennon::dns

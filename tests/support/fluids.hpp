/// A fluid about a flag whose motion is given, as the tests drive it.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>

#include "dns/fluid/fluid.hpp"
#include "dns/fluid/forces.hpp"

namespace pennon::test {

struct FluidCase {
  dns::OGridSettings grid;
  dns::FluidParameters parameters;
  int planes = 1;
  double span = 1;
  dns::FluidTolerances tolerances;
  dns::Upwinding upwinding = dns::upwinding::kawamura_kuwahara;
};

/// The displacement (y, z) of the flag's point that rests at y.
using PointMotion = std::function<std::array<double, 2>(double t, double x, double y)>;

inline std::array<double, 2> at_rest(double, double, double) {
  return {0, 0};
}

class FluidRun {
 public:
  FluidRun(const FluidCase& settings, PointMotion motion = at_rest)
      : grid_(settings.grid),
        fluid_(grid_, dns::Span(settings.planes, settings.span), settings.parameters,
               settings.tolerances, settings.upwinding),
        motion_(std::move(motion)),
        wall_([this](double t, dns::WallShape& shape) { place_wall(t, shape); }),
        state_(fluid_.impulsive_start(wall_, 0)) {}
  ~FluidRun() = default;
  FluidRun(const FluidRun&) = delete;
  FluidRun& operator=(const FluidRun&) = delete;

  dns::Fluid& fluid() { return fluid_; }
  const dns::OGrid& grid() const { return grid_; }
  dns::FluidState& state() { return state_; }
  const dns::FluidStepSummary& last() const { return last_; }
  int most_pressure_iterations() const { return most_pressure_iterations_; }

  /// Every velocity becomes the uniform stream, now and a step before.
  void fill_with_stream() {
    for (std::size_t c = 0; c < state_.u.size(); ++c)
      std::ranges::fill(state_.u[c].values(),
                        c == 0 ? 1.0 : (c == 1 ? 0.0 : fluid_.parameters().U));
    state_.u_last = state_.u;
  }

  void step(double dt) {
    last_ = fluid_.advance(state_, wall_, dt);
    most_pressure_iterations_ = std::max(most_pressure_iterations_, last_.pressure_iterations);
  }
  /// Steps of dt up to t.
  void run_to(double t, double dt) {
    for (auto n = std::lround((t - state_.t) / dt); n > 0; --n) step(dt);
  }

  dns::WallTraction traction() const { return dns::wall_traction(fluid_, state_); }
  dns::Vector3 force() const { return dns::total_force(fluid_, traction()); }
  dns::FluidBudget budget() const { return dns::fluid_budget(fluid_, state_, traction()); }

  /// function(plane, j, i) at every cell.
  template <class Function>
  void at_cells(const Function& function) const {
    const dns::Extent& extent = fluid_.extent();
    for (int plane = 0; plane < extent.planes; ++plane)
      for (int j = 0; j < extent.n_rho; ++j)
        for (int i = 0; i < extent.n_theta; ++i) function(plane, j, i);
  }

 private:
  void place_wall(double t, dns::WallShape& shape) const {
    std::size_t corner = 0;
    for (int plane = 0; plane < fluid_.span().planes(); ++plane)
      for (int i = 0; i < grid_.n_theta(); ++i, ++corner) {
        const double y = (1 + std::cos(grid_.theta(i))) / 2;
        const auto [d_y, d_z] = motion_(t, fluid_.span().x(plane), y);
        shape.y[corner] = d_y;
        shape.z[corner] = d_z;
      }
  }

  dns::OGrid grid_;
  dns::Fluid fluid_;
  PointMotion motion_;
  dns::WallMotion wall_;
  dns::FluidState state_;
  dns::FluidStepSummary last_;
  int most_pressure_iterations_ = 0;
};

}  // namespace pennon::test

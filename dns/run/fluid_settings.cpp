#include "dns/run/fluid_settings.hpp"

#include <fmt/format.h>

#include "common/case/about_key.hpp"

namespace pennon::dns {
namespace {

constexpr Range cell_count{6, 10'000};

Span span_of(std::int64_t n_x, const FlagParameters& flag) {
  return flag.gamma ? Span(static_cast<int>(n_x), *flag.gamma) : Span(1, 1.0);
}

}  // namespace

void declare_grid(Table& dns, FluidSettings& fluid) {
  dns.key({"n_rho", &fluid.n_rho, "cells from the flag to the outer boundary", cell_count})
      .key({"n_theta", &fluid.n_theta, "cells around the flag, an even number", cell_count})
      .key({"R", &fluid.R, "radius of the outer boundary, in L", Range{1, 1e4}})
      .key({"wall_spacing", &fluid.wall_spacing,
            "of rho at the flag: the first cell is wall_spacing sin(theta)/2 thick, in L",
            Range{1e-6, 1}})
      .key({"wake_clustering", &fluid.wake_clustering,
            "b of theta = t - b sin t: cells are denser toward the wake", Range{0, 0.9}});
}

void declare(Schema& schema, FluidSettings& fluid) {
  schema.table("dns.fluid", "How the fluid's equations are discretised and solved.")
      .key(
          {"convection", choice(fluid.convection, {"kawamura_kuwahara", "third_order", "central"}),
           "differences of the convective term: third-order upwind-biased with three times or once "
           "the least dissipation, or second-order central"})
      .key({"pressure_tolerance", &fluid.tolerances.pressure,
            "error that a step leaves in the pressure, root mean square, in rho_f V^2",
            Range{1e-14, 1}})
      .key({"velocity_tolerance", &fluid.tolerances.velocity, "the same of the velocity, in V",
            Range{1e-14, 1}})
      .key({"grid_tolerance", &fluid.tolerances.grid, "last change of a corner of the grid, in L",
            Range{1e-14, 1e-2}});
}

void check(const FluidSettings& fluid, std::int64_t n_x, double dt, const FlagParameters& flag,
           Faults& faults) {
  constexpr double most_cells = 1e9;
  constexpr std::int64_t fewest_planes = 4;
  if (fluid.n_theta % 2 != 0)
    about_key(faults, "dns.n_theta",
              fmt::format("= {} is odd: the edges of the flag must lie on corners of cells; take "
                          "{} or {}",
                          fluid.n_theta, fluid.n_theta - 1, fluid.n_theta + 1));
  if (flag.gamma && n_x < fewest_planes)
    about_key(faults, "dns.n_x",
              fmt::format("= {} is too few: the fluid's Fourier series along the span has at least "
                          "{} points",
                          n_x, fewest_planes));
  const double cells = static_cast<double>(fluid.n_rho) * static_cast<double>(fluid.n_theta) *
                       (flag.gamma ? static_cast<double>(n_x) : 1.0);
  if (cells > most_cells)
    about_key(faults, "dns.n_rho",
              fmt::format("= {} makes {:.3g} cells with n_theta and n_x; a grid has at most {:.0e}",
                          fluid.n_rho, cells, most_cells));
  if (fluid.first_dt && *fluid.first_dt > dt)
    about_key(faults, "dns.first_dt",
              fmt::format("= {} is larger than dns.dt = {}", *fluid.first_dt, dt));
}

Fluid fluid_of(const FluidSettings& fluid, std::int64_t n_x, const FlagParameters& flag,
               const FlowParameters& flow, double ramp) {
  const OGridSettings grid{static_cast<int>(fluid.n_rho), static_cast<int>(fluid.n_theta), fluid.R,
                           fluid.wall_spacing, fluid.wake_clustering};
  return {OGrid(grid),
          span_of(n_x, flag),
          {flow.Re, flow.U, ramp},
          fluid.tolerances,
          upwinding_of(fluid.convection)};
}

}  // namespace pennon::dns

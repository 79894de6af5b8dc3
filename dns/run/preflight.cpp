#include "dns/run/preflight.hpp"

#include <fmt/format.h>

#include <limits>

#include "common/available_memory.hpp"
#include "common/errors.hpp"
#include "dns/coupling/coupling.hpp"
#include "dns/flag/of_case.hpp"
#include "dns/grid/o_grid.hpp"
#include "dns/run/flow_mode_file.hpp"
#include "dns/run/initial_shape.hpp"

namespace pennon::dns {
namespace {

void expect_memory(const Settings& settings, const FlagParameters& flag) {
  const double cells = static_cast<double>(settings.fluid.n_rho) *
                       static_cast<double>(settings.fluid.n_theta) *
                       (flag.gamma ? static_cast<double>(settings.n_x) : 1.0);
  const double needed = memory_of_fluid(cells),
               there = available_memory().value_or(std::numeric_limits<double>::infinity());
  constexpr double gigabyte = 1e9;
  if (needed > there)
    throw InputError("dns.n_rho",
                     fmt::format("= {} makes {:.3g} cells with n_theta and n_x, which take some "
                                 "{:.2g} GB of memory, and {:.2g} GB are free; take fewer",
                                 settings.fluid.n_rho, cells, needed / gigabyte, there / gigabyte));
}

template <int dim>
void expect_shape(const Settings& settings, const FlagMesh& mesh,
                  const std::optional<ShapeFunction>& zeta) {
  (void)initial_shape<dim>(settings.initial, zeta, mesh);
}

}  // namespace

double memory_of_fluid(double cells) {
  constexpr double of_cell = 910;
  return of_cell * cells;
}

void expect_start(const Settings& settings, const FlagParameters& flag, bool has_flow,
                  const std::optional<ShapeFunction>& zeta) {
  const bool is_prescribed = has_flow && settings.motion.is_given;
  std::optional<FlagMesh> mesh;
  if (has_flow) {
    expect_memory(settings, flag);
    const FluidSettings& fluid = settings.fluid;
    const OGrid grid({static_cast<int>(fluid.n_rho), static_cast<int>(fluid.n_theta), fluid.R,
                      fluid.wall_spacing, fluid.wake_clustering});
    mesh = mesh_of(settings.flag, settings.n_x, flag, coupled_chord(grid));
  } else {
    mesh = mesh_of(settings.flag, settings.n_x, flag);
  }
  if (is_prescribed) return;
  if (!settings.initial.global_modes.empty()) {
    expect_flow_mode(settings.initial.global_modes, static_cast<int>(settings.initial.global_mode));
    return;
  }
  if (flag.gamma)
    expect_shape<3>(settings, *mesh, zeta);
  else
    expect_shape<2>(settings, *mesh, zeta);
}

}  // namespace pennon::dns

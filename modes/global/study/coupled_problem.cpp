#include "modes/global/study/coupled_problem.hpp"

#include <fmt/format.h>

#include "common/errors.hpp"
#include "common/stop_watch.hpp"
#include "dns/flag/of_case.hpp"
#include "dns/fluid/equations/wall_faces.hpp"

namespace pennon::modes::global {
namespace {

SegmentForces<double> scaled(SegmentForces<double> forces, double factor) {
  for (std::vector<double>* force : {&forces.x, &forces.y, &forces.z})
    for (double& value : *force) value *= factor;
  return forces;
}

}  // namespace

PlaneParameters plane_parameters(const FlowParameters& flow, const Settings& settings) {
  return {.Re = flow.Re,
          .U = flow.U,
          .dt_of_pressure = 2 * *settings.dt / 3,
          .upwinding = dns::upwinding_of(*settings.convection)};
}

OGrid grid_of(const Settings& settings) try {
  return OGrid({static_cast<int>(settings.n_rho), static_cast<int>(settings.n_theta), *settings.R,
                *settings.wall_spacing, *settings.wake_clustering});
} catch (const InputError& fault) {
  const InputFault& first = fault.faults().front();
  throw InputError("modes.global", fmt::format("makes no grid: {} {}", first.where, first.what));
}

CoupledProblem coupled_problem(const FlagParameters& flag, const FlowParameters& flow,
                               const Settings& settings) {
  const double k_x = *settings.k_x;
  const int stations = static_cast<int>(settings.n_x);
  StopWatch watch;
  OGrid grid = grid_of(settings);
  BaseFlow base = base_flow(grid, plane_parameters(flow, settings), k_x != 0 ? 3 : 2);
  const double base_seconds = watch.lap();
  std::vector<double> chord = dns::coupled_chord(grid);
  const dns::Edge edge = dns::leading_edge_of(flag);
  FlagOf flag_of = [chord, edge, forces = base.forces, k_x, stations](const dns::FlagMaterial& its,
                                                                      double share) {
    return flag_operator(chord, edge, its, scaled(forces, share), k_x, stations);
  };
  CoupledOperator coupled = coupled_operator(grid, base, flag_of(dns::material_of(flag), 1), k_x);
  return {std::move(grid),    std::move(base), std::move(chord), std::move(flag_of),
          std::move(coupled), base_seconds,    watch.lap()};
}

}  // namespace pennon::modes::global

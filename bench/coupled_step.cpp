// A step of flag and flow together in full flapping: case C2D of Table 1 at t = 5, in two
// dimensions, and the same flow with a small wave along a span. Counters: milliseconds of a step,
// in all and by phase; passes and iterations; memory. In two dimensions also what a step costs
// without some of its physics. On one rank; docs/accuracy.md times two by a run.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "bench/step_counters.hpp"
#include "common/petsc/petsc.hpp"
#include "dns/coupling/coupling.hpp"
#include "dns/coupling/visit_state.hpp"
#include "dns/run/initial_shape.hpp"

namespace pennon::dns {
namespace {

constexpr double dt = 0.002, span = 2, flapping = 5;
const OGridSettings grid_settings{};  // 60 x 120 cells

struct Physics {
  double U = 0, K_B = 1e-4, damping = 0.02;
  bool is_held = false;
};

template <int dim>
struct Run {
  Fluid fluid;
  Flag<dim> flag;
  Coupling<dim> coupling;
  CoupledState<dim> state;

  static FlagMesh mesh(const OGrid& grid, int planes) {
    if constexpr (dim == 2) return {coupled_chord(grid), {}};
    return {coupled_chord(grid), planes, span, {}};
  }
  Run(int planes, const Physics& physics)
      : fluid(OGrid(grid_settings), Span(planes, span), {1000, physics.U}, {}),
        flag(mesh(fluid.grid(), planes), {0.125, physics.K_B, 500, 0.3, physics.damping}),
        coupling(fluid, flag, Eigen::Matrix<double, dim, 1>::Zero(), {}) {}
};

// Flapping in two dimensions.
Run<2>& flapping_flag() {
  static Run<2> run(1, {});
  if (run.state.fluid.t == 0) {
    const auto bent = [](double, double y) { return 0.05 * y * y; };
    run.state = run.coupling.start(initial_shape<2>({}, bent, run.flag.mesh()), 0);
    for (double h = dt / 20; run.state.fluid.t < flapping; h = std::min(1.2 * h, dt))
      run.coupling.advance(run.state, h);
  }
  return run;
}

Field<double> extruded(const Field<double>& f, const Extent& extent) {
  Field<double> wide(extent);
  for (int plane = 0; plane < extent.planes; ++plane)
    std::copy(
        f.row(0, -Field<double>::ghosts),
        f.row(0, extent.n_rho + Field<double>::ghosts - 1) + extent.n_theta + Field<double>::ghosts,
        wide.row(plane, -Field<double>::ghosts));
  return wide;
}

// A state in two dimensions, the same in every plane.
class Extrusion {
 public:
  Extrusion(const Extent& extent, const FlagMesh& mesh) : extent_(extent), mesh_(mesh) {}

  void operator()(const MemberInfo&, const FluidState& from, FluidState& to) const {
    visit_both(from, to, *this);
  }
  void operator()(const MemberInfo&, const FlagState<2>& from, FlagState<3>& to) const {
    visit_both(from, to, *this);
  }
  void operator()(const MemberInfo&, const std::vector<Field<double>>& from,
                  std::vector<Field<double>>& to) const {
    for (const Field<double>& u : from) to.push_back(extruded(u, extent_));
    to.emplace_back(extent_);  // along the span
  }
  void operator()(const MemberInfo&, const Field<double>& from, Field<double>& to) const {
    to = extruded(from, extent_);
  }
  void operator()(const MemberInfo&, const std::vector<Displacement<double>>& from,
                  std::vector<Displacement<double>>& to) const {
    for (const Displacement<double>& grid : from) {
      Displacement<double>& moved = to.emplace_back(extent_);
      moved.y = extruded(grid.y, extent_);
      moved.z = extruded(grid.z, extent_);
    }
  }
  void operator()(const MemberInfo&, const std::vector<bool>& from, std::vector<bool>& to) const {
    for (int plane = 0; plane < extent_.planes; ++plane)
      to.insert(to.end(), from.begin(), from.end());
  }
  void operator()(const MemberInfo& info, const NodeVectors<2>& from, NodeVectors<3>& to) const {
    to = NodeVectors<3>::Zero(3, mesh_.nodes());
    for (int node = 0; node < mesh_.nodes(); ++node) {
      to.col(node).tail<2>() = from.col(node % mesh_.chord_nodes());
      if (info.kind == MemberKind::position) to(0, node) = mesh_.x(node / mesh_.chord_nodes());
    }
  }
  void operator()(const MemberInfo&, const SegmentValues& from, SegmentValues& to) const {
    to = from.replicate(mesh_.stations(), 1);
  }
  void operator()(const MemberInfo&, const double& from, double& to) const { to = from; }

 private:
  const Extent& extent_;
  const FlagMesh& mesh_;
};

// The flag in two dimensions at every station, and a wave of the velocity along the span.
void extrude(const Run<2>& flat, Run<3>& wide) {
  const Extent& extent = wide.fluid.extent();
  wide.state = {};
  visit_both(flat.state, wide.state, Extrusion(extent, wide.flag.mesh()));
  FluidState& fluid = wide.state.fluid;
  for (int plane = 0; plane < extent.planes; ++plane)
    for (int j = 0; j < extent.n_rho; ++j)
      for (int i = 0; i < extent.n_theta; ++i)
        for (std::vector<Field<double>>* u : {&fluid.u, &fluid.u_last})
          (*u)[0].row(plane, j)[i] +=
              0.01 * std::cos(2 * std::numbers::pi * wide.fluid.span().x(plane) / span);
}

template <int dim>
void time_steps(benchmark::State& bench, Run<dim>& run, bool is_held) {
  StepCounters counters;
  double flag = 0, passes = 0, newton = 0;
  for (auto _ : bench) {
    const CoupledStepSummary summary =
        is_held ? run.coupling.advance_held(run.state, dt) : run.coupling.advance(run.state, dt);
    counters.add(summary.fluid);
    flag += summary.flag_seconds;
    passes += summary.passes;
    newton += summary.flag_iterations;
  }
  counters.report(bench, "ms", 1e3);
  bench.counters["ms_flag"] = 1e3 * flag / counters.steps();
  bench.counters["passes"] = passes / counters.steps();
  bench.counters["newton_iterations"] = newton / counters.steps();
  constexpr double gigabyte = 1e9;
  bench.counters["GB"] = peak_memory() / gigabyte;
}

void two_dimensions(benchmark::State& bench, const Physics& physics) {
  petsc::start();
  const Run<2>& developed = flapping_flag();
  Run<2> run(1, physics);
  run.state = developed.state;
  if (physics.U != 0) {  // a third velocity, at rest in the stream
    const Field<double> across(run.fluid.extent(), physics.U);
    run.state.fluid.u.push_back(across);
    run.state.fluid.u_last.push_back(across);
    run.state.fluid.u_change.emplace_back(run.fluid.extent());
  }
  time_steps(bench, run, physics.is_held);
}

void with_span(benchmark::State& bench) {
  petsc::start();
  Run<3> run(static_cast<int>(bench.range(0)), {});
  extrude(flapping_flag(), run);
  constexpr int steps_before = 5;  // the first factors, and the wave settles
  for (int n = 0; n < steps_before; ++n) run.coupling.advance(run.state, dt);
  time_steps(bench, run, false);
}

constexpr int flat_steps = 200, wide_steps = 10;
BENCHMARK_CAPTURE(two_dimensions, whole, Physics{})
    ->Iterations(flat_steps)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_dimensions, no_damping, Physics{.damping = 0})
    ->Iterations(flat_steps)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_dimensions, no_bending, Physics{.K_B = 0})
    ->Iterations(flat_steps)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_dimensions, cross_flow, Physics{.U = 0.25})
    ->Iterations(flat_steps)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(two_dimensions, held, Physics{.is_held = true})
    ->Iterations(flat_steps)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(with_span)->Arg(24)->Arg(60)->Iterations(wide_steps)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace pennon::dns

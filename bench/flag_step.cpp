/// A time step of the flag: along the chord alone, and with a span, its tangent factored before or
/// in the step.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "dns/flag/stepper.hpp"

namespace {

using namespace pennon::dns;

const FlagMaterial material{0.125, 1e-4, 500, 0.3, 0};

template <int dim>
FlagState<dim> waving(const Flag<dim>& flag, const FlagStepper<dim>& stepper) {
  const FlagMesh& mesh = flag.mesh();
  NodeVectors<dim> x = flag.rest();
  for (int i = 0; i < mesh.stations(); ++i)
    for (int j = 0; j < mesh.chord_nodes(); ++j)
      x(dim - 1, mesh.index(i, j)) =
          0.01 * std::sin(2 * mesh.y(j)) * std::cos(std::numbers::pi * mesh.x(i));
  return stepper.start(x);
}

template <int dim>
void run(benchmark::State& state, const Flag<dim>& flag, const NewtonSettings& settings) {
  FlagStepper<dim> stepper(flag, TimeScheme::backward_difference, settings);
  FlagState<dim> flag_state = waving(flag, stepper);
  FlagLoads<dim> loads;
  loads.gravity[dim - 2] = 0.3;
  const auto loads_at = [&](double) { return loads; };
  for (int warm_up = 0; warm_up < 3; ++warm_up) stepper.advance(flag_state, loads_at, 1e-3);
  double iterations = 0;
  double factorisations = 0;
  for (auto _ : state) {
    const StepSummary summary = stepper.advance(flag_state, loads_at, 1e-3);
    iterations += summary.iterations;
    factorisations += summary.factorisations;
  }
  const auto steps = static_cast<double>(state.iterations());
  state.counters["newton"] = iterations / steps;
  state.counters["factorisations"] = factorisations / steps;
}

void chord_of_60(benchmark::State& state) {
  run<2>(state, {FlagMesh(uniform_chord(60), {}), material}, {});
}
BENCHMARK(chord_of_60)->Unit(benchmark::kMicrosecond);

void span_of_60_by_60_factored_before(benchmark::State& state) {
  run<3>(state, {FlagMesh(uniform_chord(60), 60, 2.0, {}), material}, {.contraction = 0.1});
}
BENCHMARK(span_of_60_by_60_factored_before)->Unit(benchmark::kMillisecond);

void span_of_60_by_60_factored_each_iteration(benchmark::State& state) {
  run<3>(state, {FlagMesh(uniform_chord(60), 60, 2.0, {}), material}, {});
}
BENCHMARK(span_of_60_by_60_factored_each_iteration)->Unit(benchmark::kMillisecond);

}  // namespace

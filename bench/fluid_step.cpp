// A step of the fluid about a flag along which a wave of amplitude 0.1 travels, Re = 1000, once it
// is fully developed. Counters: nanoseconds per cell and step, in all and by phase; iterations;
// memory per cell; and the bandwidth of a triad measured in the same run.
//
// On several cores: mpiexec -n N bench_fluid_step --benchmark_filter=...
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "bench/step_counters.hpp"
#include "common/petsc/petsc.hpp"

namespace pennon::dns {
namespace {

constexpr double gamma_of_span = 2;

WallMotion travelling_wave(const OGrid& grid, const Span& span) {
  std::vector<double> chord;
  chord.reserve(static_cast<std::size_t>(grid.n_theta()));
  for (int i = 0; i < grid.n_theta(); ++i) chord.push_back((1 + std::cos(grid.theta(i))) / 2);
  std::vector<double> share;
  share.reserve(static_cast<std::size_t>(span.local_planes()));
  for (int m = 0; m < span.local_planes(); ++m)
    share.push_back(span.has_span()
                        ? 1 + 0.5 * std::cos(2 * std::numbers::pi * span.x(m) / span.length())
                        : 1.0);
  return [chord, share](double t, WallShape& shape) {
    std::size_t corner = 0;
    for (const double a : share)
      for (const double y : chord) {
        shape.y[corner] = 0;
        shape.z[corner++] =
            0.1 * a * (1 - std::exp(-t * t * 25)) * y * std::sin(2 * std::numbers::pi * (y - t));
      }
  };
}

void step(benchmark::State& bench) {
  petsc::start();
  const int n_rho = static_cast<int>(bench.range(0)), planes = static_cast<int>(bench.range(1));
  OGridSettings settings;
  settings.n_rho = n_rho;
  settings.n_theta = 2 * n_rho;
  settings.wall_spacing = 0.012 * 60 / n_rho;
  const OGrid grid(settings);
  Fluid fluid(grid, Span(planes, gamma_of_span), {1000, 0}, {});
  const WallMotion wave = travelling_wave(grid, fluid.span());
  FluidState state = fluid.impulsive_start(wave, 0);
  const double dt = 0.12 / n_rho;                     // keeps the Courant number
  const int steps_before = planes == 1 ? n_rho : 20;  // past the sharpest part of the start
  for (int n = 0; n < steps_before; ++n) fluid.advance(state, wave, dt);
  StepCounters counters;
  double velocity = 0, passes = 0;
  for (auto _ : bench) {
    const FluidStepSummary summary = fluid.advance(state, wave, dt);
    counters.add(summary);
    velocity += summary.velocity_iterations;
    passes += summary.grid_passes;
  }
  const double cells = static_cast<double>(grid.n_rho()) * grid.n_theta() * planes;
  bench.counters["ns"] = 1e9 / cells * counters.seconds_of_all();
  counters.report(bench, "ns", 1e9 / cells);
  bench.counters["velocity_iterations"] = velocity / counters.steps();
  bench.counters["grid_passes"] = passes / counters.steps();
  bench.counters["bytes_per_cell"] = peak_memory() / cells;
}

// a = b + 3 c on arrays far larger than the caches: three numbers move for each element.
void triad(benchmark::State& bench) {
  constexpr std::size_t n = 20'000'000;
  std::vector<double> a(n), b(n, 1), c(n, 2);
  for (auto _ : bench) {
    for (std::size_t k = 0; k < n; ++k) a[k] = b[k] + 3 * c[k];
    benchmark::DoNotOptimize(a.data());
    benchmark::ClobberMemory();
  }
  bench.SetBytesProcessed(static_cast<std::int64_t>(bench.iterations()) * 3 * n * sizeof(double));
}

BENCHMARK(triad)->Unit(benchmark::kMillisecond);
// Cells along rho (twice as many along theta), planes. The largest last: memory is the process's
// most.
BENCHMARK(step)
    ->Args({60, 1})
    ->Args({120, 1})
    ->Args({240, 1})
    ->Args({60, 16})
    ->Args({60, 60})
    ->Args({60, 120})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

}  // namespace
}  // namespace pennon::dns

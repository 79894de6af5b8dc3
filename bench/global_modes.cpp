// Ten global modes next to one target, over the number of unknowns: seconds of steady flow,
// operator and eigenpairs (factors included), and the largest memory the process has had so far.
// Grids of n x 2n cells in two dimensions, Re = 1000; from small to large, so that the memory is
// each one's.
//
// The second number of a benchmark's name: 3 is a wave along the span with three components.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include "common/petsc/petsc.hpp"
#include "modes/global/solve/slepc/krylov_schur.hpp"
#include "modes/global/solve/slepc/mumps_factors.hpp"
#include "modes/global/study/study.hpp"

namespace pennon::modes::global {
namespace {

double largest_megabytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
}

void ten_modes(benchmark::State& bench) {
  petsc::start();
  static const SlepcSession slepc;
  const auto n = bench.range(0);
  const bool has_span = bench.range(1) == 3;
  FlagParameters flag;
  flag.mu = 0.125;
  flag.K_B = 1e-4;
  if (has_span) flag.gamma = 2;
  Settings settings;
  settings.n_modes = 10;
  settings.target = {0.9, 5};
  constexpr std::int64_t n_x = 12;
  settings =
      resolve(settings, flag, {n, 2 * n, n_x, 8, 0.03 * 60 / static_cast<double>(n), 0, 0.002});
  double base = 0, assembly = 0, eigenpairs = 0, unknowns = 0, worst = 0;
  for (auto _ : bench) {
    const FoundModes result =
        run(flag, {.Re = 1000}, settings, coupled_eigensolver(mumps_factors())).found;
    base += result.base_seconds;
    assembly += result.operator_seconds;
    eigenpairs += result.eigen_seconds;
    unknowns = static_cast<double>(result.unknowns);
    for (const GlobalMode& mode : result.modes) worst = std::max(worst, mode.residual);
    if (result.converged < result.requested) bench.SkipWithError("not all modes converged");
  }
  const auto mean = benchmark::Counter::kAvgIterations;
  bench.counters["unknowns"] = unknowns;
  bench.counters["base_s"] = benchmark::Counter(base, mean);
  bench.counters["operator_s"] = benchmark::Counter(assembly, mean);
  bench.counters["eigenpairs_s"] = benchmark::Counter(eigenpairs, mean);
  bench.counters["residual"] = worst;
  bench.counters["MB"] = largest_megabytes();
}
BENCHMARK(ten_modes)
    ->ArgsProduct({{40, 60, 98, 160, 240}, {2}})
    ->Args({60, 3})
    ->Iterations(1)
    ->Unit(benchmark::kSecond);

}  // namespace
}  // namespace pennon::modes::global

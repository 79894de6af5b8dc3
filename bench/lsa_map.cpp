/// How many points of a stability map a core evaluates a second, beside the same arithmetic written
/// as one bare loop and the bandwidth of a plain copy of as many results.
#include <benchmark/benchmark.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "lsa/batch.hpp"

namespace {

using namespace pennon::lsa;

constexpr std::size_t row_points = 1 << 16;

void map_engine(benchmark::State& state) {
  const Model model;
  const auto points = std::make_unique<PointBatch>();
  const auto results = std::make_unique<StabilityBatch>();
  points->fill({0.1, 1000, 1.0, std::numbers::pi, 0.3, 1e-4, 0});
  for (auto _ : state) {
    for (std::size_t begin = 0; begin < row_points; begin += batch_size) {
      for (std::size_t i = 0; i < batch_size; ++i)
        points->mu[i] = 1e-3 + 1e-6 * static_cast<double>(begin + i);
      solve(model, *points, batch_size, *results);
      benchmark::DoNotOptimize(results->P.data());
      benchmark::ClobberMemory();
    }
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(row_points));
}
BENCHMARK(map_engine);

// omega (4.7), P and mu_cr (4.8b) with nothing around them: constants out of the loop, straight
// from the formulas.
void bare_loop(benchmark::State& state) {
  std::vector<double> mu(row_points), re_plus(row_points), im_plus(row_points),
      re_minus(row_points), P(row_points), mu_cr(row_points);
  for (std::size_t i = 0; i < row_points; ++i) mu[i] = 1e-3 + 1e-6 * static_cast<double>(i);
  std::vector<double> Re(row_points, 1000), k_x(row_points, 1), k_y(row_points, std::numbers::pi),
      nu_s(row_points, 0.3);
  for (auto _ : state) {
    for (std::size_t i = 0; i < row_points; ++i) {
      const double tau = 1.3 / std::sqrt(Re[i]);
      const double c = std::numbers::pi / 4 * 2 * std::numbers::pi / std::abs(k_x[i]);
      const double K = tau * (k_y[i] * k_y[i] + nu_s[i] * k_x[i] * k_x[i]);
      const double D = (mu[i] + c) * K - mu[i] * c * k_y[i] * k_y[i];
      const double root = std::sqrt(std::abs(D));
      const double center = c * k_y[i] / (mu[i] + c);
      const double width = root / (mu[i] + c);
      P[i] = D / (c * k_y[i] * c * k_y[i]);
      re_plus[i] = D < 0 ? center : center + width;
      re_minus[i] = D < 0 ? center : center - width;
      im_plus[i] = D < 0 ? width : 0.0;
      mu_cr[i] = c * K / (c * k_y[i] * k_y[i] - K);
    }
    benchmark::DoNotOptimize(P.data());
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(row_points));
}
BENCHMARK(bare_loop);

}  // namespace

/// A step of the fluid asks for no memory of its own once the first are done: every call of malloc
/// is counted.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/petsc/petsc.hpp"
#include "tests/support/fluids.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

std::array<double, 2> wave(double t, double x, double y) {
  return {0, 0.02 * y * y * std::sin(2 * std::numbers::pi * (y - t)) * (1 + 0.3 * std::cos(2 * x))};
}

MemoryRequests requests_of_a_step(int planes, int n_rho) {
  FluidCase settings;
  settings.grid = {.n_rho = n_rho, .n_theta = 2 * n_rho, .R = 4, .wall_spacing = 0.05};
  settings.parameters.Re = 200;
  settings.planes = planes;
  settings.span = std::numbers::pi;
  FluidRun run(settings, wave);
  for (int warm_up = 0; warm_up < 4; ++warm_up) run.step(5e-3);
  return memory_requests_of([&] { run.step(5e-3); });
}

// PETSc makes a vector for each solution, whose numbers are kept by us (dns/numerics/krylov), and
// asks for memory for its description: some small pieces for each of the solvers.
TEST(FluidStep, AllocatesNoFieldAndNoVector) {
  petsc::start();
  constexpr std::size_t description = 4096;
  constexpr std::size_t pieces_of_a_solution = 30;
  for (const int planes : {1, 6})
    for (const int n_rho : {16, 32}) {
      const MemoryRequests requests = requests_of_a_step(planes, n_rho);
      const std::size_t solutions = planes > 1 ? 3 : 2;
      EXPECT_LE(requests.calls, solutions * pieces_of_a_solution) << planes << ' ' << n_rho;
      EXPECT_LE(requests.largest, description) << planes << ' ' << n_rho;
    }
}

TEST(FluidStep, IsWatchedByACounterThatCounts) {
  expect_that_malloc_is_counted();
}

}  // namespace
}  // namespace pennon::dns

#endif

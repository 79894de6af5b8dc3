/// A step of flag and fluid asks for no memory once the first are done: every call of malloc is
/// counted.
#include <gtest/gtest.h>

#include <numbers>

#include "common/petsc/petsc.hpp"
#include "tests/support/coupled.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

template <int dim>
MemoryRequests requests_of_a_step(int planes, int n_rho, CoupledStepSummary& summary) {
  CoupledCase settings;
  settings.grid = {.n_rho = n_rho, .n_theta = 2 * n_rho, .R = 4, .wall_spacing = 0.05};
  settings.fluid.Re = 200;
  settings.planes = planes;
  settings.span = 2;
  CoupledRun<dim> run(settings, [](double x, double y) {
    return 0.01 * y * (1 + 0.3 * std::cos(std::numbers::pi * x));
  });
  for (int warm_up = 0; warm_up < 8; ++warm_up) run.step(2e-3);
  return memory_requests_of([&] { summary = run.step(2e-3); });
}

// As for the fluid: small pieces of PETSc's for each solution. In three dimensions SuiteSparse asks
// for memory where it factors the tangent.
TEST(CoupledStep, AllocatesNoFieldAndNoVector) {
  petsc::start();
  constexpr std::size_t description = 4096;
  constexpr std::size_t pieces_of_a_solution = 30;
  for (const int n_rho : {16, 32}) {
    CoupledStepSummary summary;
    const MemoryRequests requests = requests_of_a_step<2>(1, n_rho, summary);
    const auto solutions = static_cast<std::size_t>(1 + summary.passes + summary.flag_iterations);
    EXPECT_LE(requests.calls, solutions * pieces_of_a_solution) << n_rho;
    EXPECT_LE(requests.largest, description) << n_rho;
  }
}

TEST(CoupledStep, IsWatchedByACounterThatCounts) {
  expect_that_malloc_is_counted();
}

}  // namespace
}  // namespace pennon::dns

#endif

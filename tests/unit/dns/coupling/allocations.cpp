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

// As for the fluid: small pieces of PETSc's for each solution.
template <int dim>
void expect_no_large_request(int planes, int n_rho) {
  constexpr std::size_t description = 4096;
  constexpr std::size_t pieces_of_a_solution = 30;
  CoupledStepSummary summary;
  const MemoryRequests requests = requests_of_a_step<dim>(planes, n_rho, summary);
  // SuiteSparse asks for memory while it factors; a step that keeps the tangent must not.
  EXPECT_TRUE(dim == 2 || summary.flag_factorisations == 0) << n_rho;
  const auto solutions = static_cast<std::size_t>(1 + summary.passes + summary.flag_iterations);
  EXPECT_LE(requests.calls, solutions * pieces_of_a_solution) << n_rho;
  EXPECT_LE(requests.largest, description) << n_rho;
}

TEST(CoupledStep, AllocatesNoFieldAndNoVector) {
  petsc::start();
  for (const int n_rho : {16, 32}) expect_no_large_request<2>(1, n_rho);
}

TEST(CoupledStep, AllocatesNoFieldAndNoVectorWithASpan) {
  petsc::start();
  for (const int n_rho : {16, 24}) expect_no_large_request<3>(6, n_rho);
}

TEST(CoupledStep, IsWatchedByACounterThatCounts) {
  expect_that_malloc_is_counted();
}

}  // namespace
}  // namespace pennon::dns

#endif

/// A step of flag and fluid asks for no memory once the first are done: every call of malloc is
/// counted.
#include <gtest/gtest.h>

#include <memory>
#include <numbers>

#include "common/petsc/petsc.hpp"
#include "tests/support/coupled.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

template <int dim>
std::size_t calls_of_a_step(int planes) {
  CoupledCase settings;
  settings.grid = {.n_rho = 16, .n_theta = 32, .R = 4, .wall_spacing = 0.05};
  settings.fluid.Re = 200;
  settings.planes = planes;
  settings.span = 2;
  CoupledRun<dim> run(settings, [](double x, double y) {
    return 0.01 * y * (1 + 0.3 * std::cos(std::numbers::pi * x));
  });
  for (int warm_up = 0; warm_up < 8; ++warm_up) run.step(2e-3);
  return calls_of_malloc_in([&] { run.step(2e-3); });
}

TEST(CoupledStep, AllocatesNothingAfterTheFirst) {
  petsc::start();
  EXPECT_EQ(calls_of_a_step<2>(1), 0U);
  EXPECT_EQ(calls_of_a_step<3>(6), 0U);
}

TEST(CoupledStep, IsWatchedByACounterThatCounts) {
  std::unique_ptr<NodeVectors<3>> some;
  EXPECT_GT(calls_of_malloc_in([&] { some = std::make_unique<NodeVectors<3>>(3, 100); }), 0U);
}

}  // namespace
}  // namespace pennon::dns

#endif

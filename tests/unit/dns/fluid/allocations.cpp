/// A step of the fluid asks for no memory once the first are done: every call of malloc is counted.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>

#include "common/petsc/petsc.hpp"
#include "tests/support/fluids.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

std::array<double, 2> wave(double t, double x, double y) {
  return {0, 0.05 * y * y * std::sin(2 * std::numbers::pi * (y - t)) * (1 + 0.3 * std::cos(2 * x))};
}

std::size_t calls_of_a_step(int planes) {
  FluidRun run({{.n_rho = 16, .n_theta = 32, .R = 4, .wall_spacing = 0.05},
                {.Re = 200},
                planes,
                std::numbers::pi},
               wave);
  for (int warm_up = 0; warm_up < 4; ++warm_up) run.step(5e-3);
  return calls_of_malloc_in([&] { run.step(5e-3); });
}

TEST(FluidStep, AllocatesNothingAfterTheFirst) {
  petsc::start();
  EXPECT_EQ(calls_of_a_step(1), 0U);
  EXPECT_EQ(calls_of_a_step(6), 0U);
}

TEST(FluidStep, IsWatchedByACounterThatCounts) {
  std::unique_ptr<Field<double>> some;
  EXPECT_GT(calls_of_malloc_in([&] {
              some = std::make_unique<Field<double>>(Extent{1, 8, 8});
            }),
            0U);
}

}  // namespace
}  // namespace pennon::dns

#endif

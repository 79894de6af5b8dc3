/// A time step of the flag asks for no memory once the first is done: every call of malloc is
/// counted.
#include <gtest/gtest.h>

#include "dns/flag/stepper.hpp"
#include "tests/support/flags.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

template <int dim>
std::size_t allocations_of_a_step(const FlagMesh& mesh, TimeScheme scheme, double contraction) {
  const Flag<dim> flag(mesh, {1, 0.01, 100, 0.3, 0.01});
  FlagStepper<dim> stepper(flag, scheme, {.contraction = contraction});
  FlagState<dim> state = stepper.start();
  FlagLoads<dim> weight;
  weight.gravity[dim - 1] = -1;
  const auto loads = [&](double) { return weight; };
  for (int warm_up = 0; warm_up < 4; ++warm_up) stepper.advance(state, loads, 1e-3);
  StepSummary summary;
  const std::size_t calls =
      calls_of_malloc_in([&] { summary = stepper.advance(state, loads, 1e-3); });
  // SuiteSparse asks for memory while it factors; a step that keeps the tangent must not.
  EXPECT_TRUE(dim == 2 || summary.factorisations == 0);
  return calls;
}

TEST(FlagStep, AllocatesNothingAfterTheFirst) {
  for (const TimeScheme scheme : {TimeScheme::energy_conserving, TimeScheme::backward_difference}) {
    EXPECT_EQ(allocations_of_a_step<2>(FlagMesh(uniform_chord(20), {}), scheme, 0), 0U);
    EXPECT_EQ(allocations_of_a_step<3>(FlagMesh(uniform_chord(10), 8, 1.0, {}), scheme, 0.5), 0U);
  }
}

TEST(FlagStep, IsWatchedByACounterThatCounts) {
  expect_that_malloc_is_counted();
}

}  // namespace
}  // namespace pennon::dns

#endif

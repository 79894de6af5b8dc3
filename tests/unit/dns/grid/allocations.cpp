/// Following the flag, the metrics and the flat solver ask for no memory once they have run: every
/// call of malloc is counted.
#include <gtest/gtest.h>

#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/metrics.hpp"
#include "tests/support/grids.hpp"
#include "tests/support/malloc_counter.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace pennon::dns {
namespace {

using namespace pennon::test;

template <class Function>
std::size_t calls_of_a_second(const Function& function) {
  function();
  return calls_of_malloc_in(function);
}

TEST(MovingGrid, AllocatesNothingAfterTheFirstPasses) {
  for (const double wake_clustering : {0.0, 0.5}) {
    const OGrid grid({20, 40, 8, 0.03, wake_clustering});
    EllipticGrid elliptic(grid);
    Displacement<double> displacement(extent_of(grid));
    Metrics<double> metrics(extent_of(grid), true);
    EXPECT_EQ(calls_of_a_second([&] {
                elliptic.relax(0, displacement, 0, 2);
                update_metrics(grid, 0, displacement, &displacement, metrics);
              }),
              0U);
  }
}

TEST(MovingGrid, IsWatchedByACounterThatCounts) {
  expect_that_malloc_is_counted();
}

}  // namespace
}  // namespace pennon::dns

#endif

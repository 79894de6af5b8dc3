/// Following the flag, the metrics and the flat solver ask for no memory once they have run: every
/// call of malloc is counted.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <memory>

#include "dns/elliptic_grid.hpp"
#include "dns/metrics.hpp"
#include "tests/support/grids.hpp"

#if !defined(__SANITIZE_ADDRESS__)

namespace {
std::atomic<std::size_t> calls{0};
}

// glibc's own allocator, under the name that everything asks for.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is glibc's
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* malloc(std::size_t size) {
  calls.fetch_add(1, std::memory_order_relaxed);
  return __libc_malloc(size);
}

namespace pennon::dns {
namespace {

using namespace pennon::test;

template <class Function>
std::size_t calls_of_a_second(const Function& function) {
  function();
  const std::size_t before = calls;
  function();
  return calls - before;
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
  const std::size_t before = calls;
  const auto some = std::make_unique<Field<double>>(Extent{1, 8, 8});
  EXPECT_GT(calls - before, 0U) << some->values().size();
}

}  // namespace
}  // namespace pennon::dns

#endif

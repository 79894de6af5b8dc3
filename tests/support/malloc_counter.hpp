/// Counts every call of malloc in a program, and remembers the largest request. Takes the place of
/// malloc, so it is included by one file of a program of its own; there is none under the address
/// sanitizer, which has its own.
#pragma once

#if !defined(__SANITIZE_ADDRESS__)

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <cstdlib>
#include <memory>
#include <vector>

namespace pennon::test {

inline std::atomic<std::size_t> calls_of_malloc{0}, largest_request{0};

/// Of `function`.
template <class Function>
std::size_t calls_of_malloc_in(const Function& function) {
  const std::size_t before = calls_of_malloc;
  function();
  return calls_of_malloc - before;
}

/// How often a function asks for memory, and the most that it asks for at once, in bytes.
struct MemoryRequests {
  std::size_t calls = 0, largest = 0;
};
template <class Function>
MemoryRequests memory_requests_of(const Function& function) {
  largest_request = 0;
  const std::size_t calls = calls_of_malloc_in(function);
  return {calls, largest_request};
}

/// The counter itself: without it a test of allocations could not fail.
inline void expect_that_malloc_is_counted() {
  std::unique_ptr<std::vector<double>> some;
  EXPECT_GT(calls_of_malloc_in([&] { some = std::make_unique<std::vector<double>>(100); }), 0U);
}

}  // namespace pennon::test

// glibc's own allocator, under the name that everything asks for.
// NOLINTNEXTLINE(bugprone-reserved-identifier): the name is glibc's
extern "C" void* __libc_malloc(std::size_t);
// NOLINTNEXTLINE(misc-definitions-in-headers): of one file, as said above
extern "C" void* malloc(std::size_t size) {
  pennon::test::calls_of_malloc.fetch_add(1, std::memory_order_relaxed);
  if (size > pennon::test::largest_request.load(std::memory_order_relaxed))
    pennon::test::largest_request.store(size, std::memory_order_relaxed);
  return __libc_malloc(size);
}

#endif

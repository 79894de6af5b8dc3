// Work arrays are lent to one user at a time, and lent again once returned.
#include "dns/grid/scratch.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "dns/grid/field.hpp"

namespace pennon::dns {
namespace {

using Vectors = Scratch<std::vector<double>>;

Vectors vectors() {
  return Vectors([] { return std::vector<double>(4); });
}

TEST(Scratch, LendsDifferentArraysAtTheSameTime) {
  Vectors scratch = vectors();
  const Vectors::Lease a = scratch.lease("a"), b = scratch.lease("b");
  EXPECT_NE(a.get(), b.get());
  EXPECT_EQ(scratch.size(), 2U);
}

TEST(Scratch, LendsAReturnedArrayAgainAndMakesNoOther) {
  Vectors scratch = vectors();
  Vectors::Lease a = scratch.lease("a");
  const std::vector<double>* array = a.get();
  a.release();
  EXPECT_FALSE(a);
  EXPECT_EQ(scratch.lease("b").get(), array);
  EXPECT_EQ(scratch.size(), 1U);
}

TEST(Scratch, KeepsWhatIsLentFromMovingAndPassesALeaseOn) {
  Vectors scratch = vectors();
  Vectors::Lease first = scratch.lease("first");
  (*first)[0] = 7;
  std::vector<Vectors::Lease> others;
  others.reserve(3);
  for (const char* name : {"second", "third", "fourth"}) others.push_back(scratch.lease(name));
  const Vectors::Lease moved = std::move(first);
  EXPECT_EQ((*moved)[0], 7);
  EXPECT_EQ(scratch.size(), 4U);
}

#if !defined(NDEBUG)
TEST(ScratchDeathTest, AssertsWhereANameIsLentTwice) {
  Vectors scratch = vectors();
  const Vectors::Lease a = scratch.lease("a");
  EXPECT_DEATH(scratch.lease("a"), "lent twice");
}

TEST(Scratch, LendsArraysThatShowWhereNothingWasWritten) {
  Scratch<Field<double>> scratch([] { return Field<double>(Extent{1, 2, 3}); });
  EXPECT_TRUE(std::isnan(scratch.lease("f")->row(0, 0)[0]));
}
#endif

}  // namespace
}  // namespace pennon::dns

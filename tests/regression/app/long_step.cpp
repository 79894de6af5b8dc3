/// A long step of a flag by itself is left at a signal.
#include <fmt/format.h>

#include "tests/support/long_step.hpp"

namespace pennon {
namespace {

using test::LongStep;

TEST_F(LongStep, OfAFlagIsLeftAtASignalAndTakenAgainToTheSameBits) {
  const std::string file = test::write_text(
      folder_ / "flag.toml",
      "[flag]\nmu = 1\nK_B = 1e-3\n[dns]\ndt = 0.01\nt_end = 0.02\n[dns.flag]\nn_y = 20000\n"
      "[dns.initial]\nangle = 0.2\n[dns.output]\ncheckpoint_interval = 0.01\n");
  expect_left({"dns", file}, "flag", 1);
}

}  // namespace
}  // namespace pennon

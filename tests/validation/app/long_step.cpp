/// A long step of flag and flow is left at a signal. Its steps must take longer than the half
/// second in which a step may end: the faster the machine, the more cells that needs.
#include <fmt/format.h>

#include "tests/support/long_step.hpp"

namespace pennon {
namespace {

using test::LongStep;

TEST_F(LongStep, OfFlagAndFlowIsLeftAtASignalAndTakenAgainToTheSameBits) {
  const std::string file = test::write_text(
      folder_ / "span.toml",
      "[flag]\nmu = 0.125\nK_B = 1e-4\ndamping = 0.02\ngamma = 2\n[flow]\nRe = 500\n[dns]\n"
      "n_x = 16\nn_rho = 128\nn_theta = 384\nwall_spacing = 0.01\ndt = 1e-3\nt_end = 2e-3\n"
      "first_dt = 1e-3\n[dns.initial]\nA = [0.05, 0.01]\n[dns.output]\n"
      "checkpoint_interval = 1e-3\n");
  for (const int ranks : {1, 2})
    ASSERT_NO_FATAL_FAILURE(expect_left({"dns", file}, fmt::format("on{}", ranks), ranks));
}

}  // namespace
}  // namespace pennon

/// The tables of the simulation, and the faults between their keys.
#include "dns/run/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/errors.hpp"

namespace pennon::dns {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string faults_of(const std::string& text, bool is_asked_for) {
  Schema schema;
  FlagParameters flag;
  FlowParameters flow;
  bool has_flow = false;
  Settings settings;
  declare(schema, flag);
  declare(schema, flow, has_flow);
  declare(schema, settings);
  Faults faults = read_case_text(text, "flag.toml", {}, schema);
  check(settings, flag, has_flow, is_asked_for, faults);
  try {
    faults.raise();
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

const std::string in_plane = "[flag]\nmu = 0.1\n", spatial = in_plane + "gamma = 2\n";

TEST(DnsSettings, AreCheckedWithoutTheirTableWhereTheSimulationIsAskedFor) {
  const std::string sideways = in_plane + "gravity = [1, 0, 0]\n";
  EXPECT_THAT(faults_of(sideways, true), HasSubstr("flag.gravity acts along x"));
  EXPECT_EQ(faults_of(sideways, false), "");
  EXPECT_THAT(faults_of(sideways + "[dns]\n", false), HasSubstr("flag.gravity acts along x"));
}

TEST(DnsSettings, RefuseMoreStepsThanARunHas) {
  EXPECT_THAT(faults_of(in_plane + "[dns]\ndt = 1e-10\n", true),
              AllOf(StartsWith("flag.toml:4: dns.dt = 1e-10"), HasSubstr("1e+10 steps")));
  EXPECT_EQ(
      faults_of(in_plane + "K_B = 1\n[dns]\ndt = 1e-10\n[dns.flag]\nequilibrium = true\n", true),
      "");
}

// A convergence study puts its own numbers in the place of those that a case gives.
TEST(DnsSettings, RefuseConvergenceStudiesOfFlagsThatAreTooLarge) {
  const std::string grids =
      spatial + "K_B = 1\n[dns.flag]\nequilibrium = true\n[dns.convergence]\nn = [10, 2000]\n";
  EXPECT_THAT(faults_of(grids, true),
              AllOf(StartsWith("flag.toml:8: dns.convergence.n = 2000"), HasSubstr("4e+06 nodes")));
  EXPECT_THAT(faults_of(in_plane + "[dns.convergence]\ndt = [0.1, 1e-10]\n", true),
              AllOf(StartsWith("flag.toml:4: dns.convergence.dt = 1e-10"), HasSubstr("steps")));
}

TEST(DnsSettings, RefuseAModeAlongASpanThatIsNotThere) {
  const std::string moving = in_plane + "[flow]\nRe = 100\n[dns.motion]\nkind = \"mode\"\nn = 1\n";
  EXPECT_THAT(faults_of(moving, true), HasSubstr("dns.motion.n varies along the span"));
  EXPECT_THAT(faults_of(in_plane + "[dns.initial]\nmode_amplitude = 0.1\nn = 1\n", true),
              HasSubstr("dns.initial.n varies along the span"));
}

TEST(DnsSettings, SayWhichNormalModeARunNeeds) {
  Settings settings;
  EXPECT_FALSE(normal_mode_of(settings, true));
  settings.initial.mode_amplitude = 0.1;
  settings.initial.m = 3;
  ASSERT_TRUE(normal_mode_of(settings, false));
  EXPECT_EQ(normal_mode_of(settings, false)->m, 3);
  settings.motion.is_given = true;
  EXPECT_FALSE(normal_mode_of(settings, true)) << "the flag moves as prescribed, and not as a mode";
  settings.motion.kind = MotionKind::mode;
  settings.motion.m = 2;
  EXPECT_EQ(normal_mode_of(settings, true)->m, 2);
  EXPECT_EQ(normal_mode_of(settings, false)->m, 3) << "without a flow the motion is of no use";
  settings.initial.global_modes = "modes.h5";
  EXPECT_FALSE(normal_mode_of(settings, false));
}

}  // namespace
}  // namespace pennon::dns

/// The tables [modes.normal] and [modes.decompose] of a case, and the faults between their keys.
#include "modes/normal/settings.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

struct Case {
  FlagParameters flag;
  FlowParameters flow;
  Settings settings;
  bool has_flow = false;
  Schema schema;

  explicit Case(const std::string& text) {
    declare(schema, flag);
    declare(schema, flow, has_flow);
    declare(schema, settings);
    Faults faults = read_case_text(text, "flag.toml", {}, schema);
    check(settings, flag, flow, false, faults);
    faults.raise();
  }
};

const std::string plane = "[flag]\nmu = 0.1\n[flow]\nRe = 1000\n";
const std::string spatial = "[flag]\nmu = 0.1\ngamma = 2\n[flow]\nRe = 1000\n";

std::string faults_of(const std::string& text) {
  try {
    Case{text};
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(ModesSettings, TakeThreeSpanwiseWavesUnlessTold) {
  const Case spatial_case(spatial + "[modes.normal]\n");
  EXPECT_TRUE(spatial_case.settings.is_given);
  EXPECT_THAT(mode_range(spatial_case.settings, spatial_case.flag).n, ElementsAre(0, 1, 2));
  const Case plane_case(plane + "[modes.normal]\n");
  EXPECT_THAT(mode_range(plane_case.settings, plane_case.flag).n, ElementsAre(0));
}

TEST(ModesSettings, TakeEachWaveOnceAndInOrder) {
  const Case given(spatial + "[modes.normal]\nn = [3, 0, 3]\nm = 7\n");
  const ModeRange range = mode_range(given.settings, given.flag);
  EXPECT_THAT(range.n, ElementsAre(0, 3));
  EXPECT_EQ(range.m, 7);
}

TEST(ModesSettings, ReadBackWhatTheyResolveTo) {
  const Case given(spatial +
                   "[modes.normal]\nfamily = \"in_vacuo\"\ntension = \"linear\"\nn = [1, 4]\n"
                   "elements = 90\n[modes.decompose]\nA = [0.1, 0.2]\nB = [0, 0.3]\n");
  const std::string resolved = resolved_text(given.schema);
  const Case again(resolved);
  EXPECT_EQ(resolved_text(again.schema), resolved);
  EXPECT_EQ(again.settings.family, Family::in_vacuo);
  EXPECT_EQ(again.settings.tension, TensionProfile::linear);
  EXPECT_THAT(again.settings.decompose.B, ElementsAre(0, 0.3));
}

TEST(ModesSettings, OfAMisspeltFamilyNameTheNearest) {
  EXPECT_THAT(faults_of(plane + "[modes.normal]\nfamily = \"hanging_chian\"\n"),
              AllOf(StartsWith("flag.toml:6: "), HasSubstr("hanging_chain")));
}

TEST(ModesSettings, RefuseSpanwiseWavesInTwoDimensions) {
  EXPECT_THAT(faults_of(plane + "[modes.normal]\nn = [0, 2]\n"),
              AllOf(StartsWith("flag.toml:6: "), HasSubstr("n holds 2"), HasSubstr("n = 0 only")));
}

TEST(ModesSettings, RefuseMoreWavesThanThereAreBesselZeros) {
  EXPECT_THAT(faults_of(spatial + "[modes.normal]\nn = [201]\n"), HasSubstr("n = 0 to 200"));
  EXPECT_EQ(faults_of(spatial + "[modes.normal]\nn = [201]\nfamily = \"hanging_chain\"\n"), "");
}

TEST(ModesSettings, RefuseMoreModesThanTheElementsResolve) {
  EXPECT_THAT(faults_of(plane + "[modes.normal]\nfamily = \"in_vacuo\"\nm = 30\nelements = 40\n"),
              AllOf(StartsWith("flag.toml:7: "), HasSubstr("take 60 or more")));
  EXPECT_THAT(
      faults_of(plane + "[modes.normal]\nfamily = \"in_vacuo\"\nm = 201\nelements = 2010\n"),
      HasSubstr("m = 1 to 200"));
}

TEST(ModesSettings, RefuseAFlagInVacuumThatNothingHolds) {
  EXPECT_THAT(faults_of("[flag]\nmu = 0.1\n[modes.normal]\nfamily = \"in_vacuo\"\n"),
              HasSubstr("needs a tension"));
  EXPECT_EQ(faults_of("[flag]\nmu = 0.1\nK_B = 1\n[modes.normal]\nfamily = \"in_vacuo\"\n"), "");
}

TEST(ModesSettings, RefuseMoreShapeValuesThanFit) {
  EXPECT_THAT(faults_of(plane + "[modes.normal]\nm = 1000\nshape_points = 1000000\n"),
              HasSubstr("at most 1e+08 values"));
}

TEST(ModesSettings, RefuseToDecomposeTwoThingsOrNothing) {
  const std::string normal = spatial + "[modes.normal]\n[modes.decompose]\n";
  EXPECT_THAT(faults_of(normal), HasSubstr("nothing to decompose"));
  EXPECT_THAT(faults_of(normal + "samples = \"a.csv\"\nA = [1]\n"),
              HasSubstr("both samples and amplitudes"));
  EXPECT_THAT(faults_of(spatial + "[modes.decompose]\nA = [1]\n"),
              HasSubstr("needs [modes.normal]"));
}

TEST(ModesSettings, RefuseAmplitudesThatHaveNoEffect) {
  EXPECT_THAT(faults_of(spatial + "[modes.normal]\n[modes.decompose]\nB = [0.1, 0.1]\n"),
              HasSubstr("B_0 = 0.1"));
  EXPECT_THAT(faults_of(plane + "[modes.normal]\n[modes.decompose]\nA = [0.1, 0.1]\n"),
              HasSubstr("only A = [A_0] is right"));
}

}  // namespace
}  // namespace pennon::modes

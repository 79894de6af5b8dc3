/// What is reported of the global modes, from findings that are given.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "common/io/csv.hpp"
#include "common/shape_phases.hpp"
#include "modes/global/study/map_report.hpp"
#include "modes/global/study/modes_report.hpp"
#include "modes/global/study/neutral_report.hpp"
#include "tests/support/global_findings.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::modes::global {
namespace {

using Json = nlohmann::ordered_json;
using test::global_findings;
using test::TemporaryFolder;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

TEST(GlobalModesReport, GivesTheJsonThatScriptsRelyOn) {
  const Json json = to_json(global_findings().spectrum);
  EXPECT_THAT(keys_of(json),
              ElementsAre("base_flow", "requested", "converged", "searched", "box", "too_fast",
                          "checked_in_larger_box", "biorthogonality_defect", "modes"));
  EXPECT_THAT(keys_of(json["base_flow"]),
              ElementsAre("drag_coefficient", "tension_leading_edge", "residual"));
  EXPECT_EQ(json["base_flow"]["tension_leading_edge"], 0.05);
  EXPECT_THAT(keys_of(json["modes"][0]),
              ElementsAre("growth", "omega", "frequency", "residual", "kind", "shares",
                          "adjoint_residual", "sensitivity"));
  EXPECT_EQ(json["modes"][0]["kind"], "flag");
  EXPECT_EQ(json["modes"][1]["kind"], "box");
  EXPECT_EQ(json["modes"][1]["shares"],
            Json({{"flag", 0.01}, {"near", 0.04}, {"wake", 0.15}, {"outer", 0.8}}));
  EXPECT_EQ(json["modes"][0]["frequency"], 2.6 / (2 * std::numbers::pi));
  EXPECT_EQ(json["modes"][0]["sensitivity"]["ln_tension"], Json({7.0, 8.0}));
  EXPECT_THAT(keys_of(json["modes"][1]),
              ElementsAre("growth", "omega", "frequency", "residual", "kind", "shares"));
}

TEST(GlobalModesReport, ListsTheModesOfTheBoxApart) {
  const std::string text = text_of(global_findings().spectrum);
  const std::size_t of_flag = text.find("2.6 "), box = text.find("7 pairs belong to the box"),
                    of_box = text.find("-5.1 ");
  ASSERT_NE(of_box, std::string::npos);
  EXPECT_LT(of_flag, box);
  EXPECT_LT(box, of_box);
  EXPECT_THAT(text,
              HasSubstr("2 of those asked for are not among the 12 pairs next to each target"));
  EXPECT_THAT(text, HasSubstr("3 eigenvalues with |lambda| dt > 1 are left out"));
}

TEST(GlobalModesReport, TabulatesTheFlagAtThePhases) {
  const TemporaryFolder folder;
  const FoundModes found = global_findings().spectrum;
  write_tables(found, OutputFolder(folder.path()));
  EXPECT_EQ(CsvTable(folder / "global_modes.csv").numbers("omega"),
            (std::vector<double>{2.6, -5.1}));
  const CsvTable shapes(folder / "global_shapes.csv");
  ASSERT_EQ(shapes.rows(), 6u);
  for (const int phase : shape_phases) {
    if (phase == 0) continue;
    const std::vector<double> at = shapes.numbers("at_" + std::to_string(phase));
    for (std::size_t k = 0; k < 6; ++k) {
      const std::complex<double> turned =
          found.modes[k / 3].zeta[k % 3] * std::polar(1.0, phase * std::numbers::pi / 180);
      EXPECT_NEAR(at[k], turned.real(), 1e-15);
    }
  }
}

TEST(GlobalNeutralReport, SaysNullWhereThereIsNoNumber) {
  const Json json = to_json(*global_findings().neutral);
  EXPECT_THAT(keys_of(json), ElementsAre("neutral", "neutral_over", "neutral_missing"));
  EXPECT_EQ(json["neutral_over"], "K_B");
  const Json &first = json["neutral"][0], &second = json["neutral"][1];
  EXPECT_THAT(keys_of(first),
              ElementsAre("K_B", "mu_cr", "omega", "branch", "residual", "fit_error",
                          "largest_growth", "distance", "evaluations", "wall_s", "modes"));
  EXPECT_EQ(first["mu_cr"], 0.11);
  EXPECT_EQ(first["distance"], 2e-8);
  EXPECT_EQ(first["modes"][1]["growth_by_mu"], -0.7);
  for (const char* absent : {"fit_error", "largest_growth", "distance"})
    EXPECT_TRUE(second[absent].is_null()) << absent;
  EXPECT_EQ(json["neutral_missing"],
            Json::array({{{"K_B", 3e-4}, {"fault", "no neutral mode \"there\""}}}));
}

TEST(GlobalNeutralReport, LeavesCellsEmptyWhereThereIsNoNumber) {
  const TemporaryFolder folder;
  write_tables(*global_findings().neutral, OutputFolder(folder.path()));
  const CsvTable curve(folder / "global_neutral.csv"),
      branches(folder / "global_neutral_branches.csv");
  EXPECT_EQ(curve.numbers("mu_cr"), (std::vector<double>{0.11, 0.42}));
  EXPECT_EQ(curve.numbers("fit_error").front(), 3e-6);
  EXPECT_TRUE(std::isnan(curve.numbers("fit_error").back()));
  EXPECT_EQ(branches.numbers("branch"), (std::vector<double>{0, 1, 1}));
}

TEST(GlobalNeutralReport, WritesBranchesOtherTheoriesAndOutcomesForThePicture) {
  const TemporaryFolder folder;
  NeutralPicture picture{.title = "stiffness",
                         .axis = {{"name", "K_B"}, {"scale", "log"}},
                         .local_theory = {{"wu", {1, 2, 3}, {4, 5, 6}}}};
  picture.outcomes.add(0.5, 0.25, true);
  write_hdf5(*global_findings().neutral, picture, folder / "neutral.h5");
  const hdf5::Reader file(folder / "neutral.h5");
  EXPECT_EQ(file.text("/", "kind"), "global_neutral");
  EXPECT_EQ(file.text("/x", "scale"), "log");
  EXPECT_EQ(file.read("/mu_cr").values, (std::vector<double>{0.11, 0.42}));
  const hdf5::Array branches = file.read("/branches");
  ASSERT_EQ(branches.shape, (hdf5::Shape{2, 2}));
  EXPECT_EQ(branches.values[0], 0.11);
  EXPECT_TRUE(std::isnan(branches.values[1]));
  EXPECT_EQ(branches.values[2], 0.42);
  EXPECT_EQ(branches.values[3], 0.42);
  EXPECT_EQ(file.read("/local/wu/y").values, (std::vector<double>{4, 5, 6}));
  EXPECT_EQ(file.read("/marks/unstable").values, (std::vector<double>{1}));
}

TEST(GlobalNeutralReport, TellsWhereAnotherModeIsTheFirstAndWhatIsLeftOut) {
  const std::string text = text_of(*global_findings().neutral);
  EXPECT_THAT(text, HasSubstr("     0.0002        0.42        -8.1       2  another mode is the "
                              "first to grow\n"));
  EXPECT_THAT(text, HasSubstr("largest growth rate -1.0e-08, an eigenvalue 2.0e-08 from i omega"));
  EXPECT_THAT(text, HasSubstr("left out: K_B = 0.0003: no neutral mode"));
}

TEST(GlobalMapReport, HasNoNeutralCurveBeyondTheMap) {
  const TemporaryFolder folder;
  GrowthMap map = *global_findings().map;
  map.neutral = {{0.15, 0.9}, {0.5}};  // the map ends at 0.4
  write_hdf5(map, {.title = "", .x_axis = {}, .mu_axis = {}}, folder / "map.h5");
  const std::vector<double> neutral = hdf5::Reader(folder / "map.h5").read("/neutral/y").values;
  ASSERT_EQ(neutral.size(), 2u);
  EXPECT_EQ(neutral[0], 0.15);
  EXPECT_TRUE(std::isnan(neutral[1]));
}

TEST(GlobalMapReport, HasARowForEachPointAndASummaryWithoutTheArrays) {
  const TemporaryFolder folder;
  const GrowthMap map = *global_findings().map;
  write_tables(map, OutputFolder(folder.path()));
  const CsvTable table(folder / "global_map.csv");
  EXPECT_EQ(table.numbers("nu_s"), (std::vector<double>{0, 0.3, 0, 0.3, 0, 0.3}));
  EXPECT_EQ(table.numbers("growth").back(), 0.4);
  EXPECT_TRUE(std::isnan(table.numbers("growth")[1]));
  EXPECT_THAT(
      keys_of(to_json(map)),
      ElementsAre("points", "basis_size", "fit_error", "basis_error", "checked_basis",
                  "lambda_error", "checked", "samples", "samples_off_axis", "sample_s", "map_s"));
  EXPECT_EQ(to_json(map)["points"], 6);
}

TEST(GlobalMapReport, SaysWhereTheErrorIsLargerThanWasAskedFor) {
  const GrowthMap map = *global_findings().map;
  EXPECT_THAT(text_of(map, 1e-7), HasSubstr("more than modes.global.map.lambda_tolerance"));
  EXPECT_THAT(text_of(map, 1e-6), Not(HasSubstr("lambda_tolerance")));
}

}  // namespace
}  // namespace pennon::modes::global

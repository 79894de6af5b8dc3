/// The study of a case: what it computes, and what it writes.
#include "modes/normal/study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "modes/normal/bessel_zero.hpp"
#include "modes/normal/report.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::modes {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double roundoff = 1e-12;

FlagParameters flag() {
  FlagParameters flag;
  flag.mu = 0.125;
  flag.gamma = 2;
  return flag;
}
const FlowParameters flow{1000, 0};

TEST(ModesStudy, ListsTheModesItWasAskedFor) {
  Settings settings;
  settings.m = 2;
  settings.shape_points = 11;
  const Result result = run(settings, flag(), flow);
  ASSERT_EQ(result.modes.modes.size(), 6u);
  ASSERT_EQ(result.shapes.size(), 6u);
  EXPECT_EQ(result.y.size(), 11u);
  EXPECT_EQ(result.y.back(), 1);
  EXPECT_EQ(result.shapes[0].back(), 1);  // J_0(0)
  EXPECT_FALSE(result.decomposition.has_value());
}

TEST(ModesStudy, GivesTheJsonThatScriptsRelyOn) {
  Settings settings;
  settings.n = {1};
  settings.m = 1;
  const nlohmann::ordered_json list = to_json(run(settings, flag(), flow));
  ASSERT_EQ(list.size(), 1u);
  std::vector<std::string> keys;
  for (const auto& [key, value] : list[0].items()) keys.push_back(key);
  EXPECT_THAT(keys, ElementsAre("family", "n", "m", "k_x", "alpha", "omega", "frequency"));
  EXPECT_EQ(list[0]["family"], "bessel");
  EXPECT_EQ(list[0]["alpha"], bessel_zero(1, 1));
}

TEST(ModesStudy, WritesTablesThatReadBack) {
  Settings settings;
  settings.family = Family::hanging_chain;
  settings.shape_points = 21;
  settings.decompose = {true, "", {0.1, 0.2}, {0, 0.3}};
  const TemporaryFolder folder;
  const Result result = run(settings, flag(), flow);
  write_tables(result, OutputFolder(folder.path()));

  const CsvTable table(folder / "modes.csv");
  ASSERT_EQ(table.rows(), 9u);
  EXPECT_EQ(table.text(0, table.column("family")), "hanging_chain");
  for (std::size_t i = 0; i < 9; ++i) {
    EXPECT_EQ(table.number(i, table.column("omega")), result.modes.modes[i].omega);
    EXPECT_EQ(table.number(i, table.column("n")), result.modes.modes[i].n);
  }

  const hdf5::Reader file(folder / "modes.h5");
  EXPECT_EQ(file.text("/", "kind"), "normal_modes");
  EXPECT_EQ(file.text("/", "family"), "hanging_chain");
  EXPECT_THAT(file.shape("/shapes"), ElementsAre(9, 21));
  EXPECT_EQ(file.read("/shapes").values[21 + 20], result.shapes[1][20]);
  EXPECT_EQ(file.text("/omega", "unit"), "V/L");
  EXPECT_FALSE(file.text("/shapes", "meaning").empty());

  const CsvTable amplitudes(folder / "decomposition.csv");
  EXPECT_EQ(amplitudes.rows(), 9u);
  EXPECT_EQ(amplitudes.number(4, amplitudes.column("B")), result.decomposition->amplitudes[4].B);
}

TEST(ModesStudy, FindsTheInitialShapeAmongTheBesselModes) {
  Settings settings;
  settings.decompose = {true, "", {0.1, 0.2}, {0, 0.3}};
  const Decomposition result = *run(settings, flag(), flow).decomposition;
  EXPECT_LT(result.truncation_error, roundoff);
  for (const auto& [n, m, A, B] : result.amplitudes) {
    EXPECT_NEAR(A, m > 1 || n > 1 ? 0 : n == 0 ? 0.1 : 0.2, roundoff);
    EXPECT_NEAR(B, m == 1 && n == 1 ? 0.3 : 0, roundoff);
  }
}

TEST(ModesStudy, DecomposesTheSamplesOfAFile) {
  const TemporaryFolder folder;
  std::string text = "x,y,zeta\n";
  const double alpha = bessel_zero(1, 2);
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j) {
      const double x = i / 6.0;
      const double y = j / 11.0;
      text += std::to_string(x) + "," + std::to_string(y) + "," +
              std::to_string(0.4 * std::sin(3.14159265358979 * x) *
                             std::cyl_bessel_j(1, alpha * (1 - y))) +
              "\n";
    }
  write_file(folder / "wave.csv", text);
  Settings settings;
  settings.decompose.is_given = true;
  settings.decompose.samples = (folder / "wave.csv").string();
  const Decomposition result = *run(settings, flag(), flow).decomposition;
  constexpr double printed_digits = 1e-5;  // std::to_string keeps six
  for (const auto& [n, m, A, B] : result.amplitudes) {
    EXPECT_NEAR(A, 0, printed_digits);
    EXPECT_NEAR(B, n == 1 && m == 2 ? 0.4 : 0, printed_digits);
  }
  EXPECT_LT(result.truncation_error, printed_digits);
}

TEST(ModesStudy, NamesEverySampleThatIsWrong) {
  const TemporaryFolder folder;
  write_file(folder / "wave.csv", "y,zeta\n0.5,0.1\n1.5,0.1\n0.7,\n");
  try {
    read_samples(folder / "wave.csv", false);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("wave.csv:3: y must be 0 to 1, but is 1.5"));
    EXPECT_THAT(error.what(), HasSubstr("wave.csv:4: zeta is missing"));
  }
}

TEST(ModesStudy, GivesNullForTheAlphaOfAFlagWithoutAStream) {
  FlagParameters still = flag();
  still.K_B = 1;
  Settings settings;
  settings.family = Family::in_vacuo;
  settings.elements = 40;
  settings.n = {0};
  EXPECT_NE(to_json(run(settings, still, {})).dump().find("\"alpha\":null"), std::string::npos);
}

}  // namespace
}  // namespace pennon::modes

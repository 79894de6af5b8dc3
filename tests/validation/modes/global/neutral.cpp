// The neutral curves that are kept, on the grid of the paper.
#include <gtest/gtest.h>

#include <string>

#include "common/io/csv.hpp"
#include "modes/global/study/linearisation.hpp"
#include "tests/support/source_folder.hpp"

namespace pennon::modes::global {
namespace {

Settings settings() {
  Settings wanted;
  wanted.is_given = true;
  return resolve(wanted, {.mu = 1, .gamma = {}},
                 {.n_rho = 60,
                  .n_theta = 120,
                  .n_x = 60,
                  .R = 8,
                  .wall_spacing = 0.012,
                  .wake_clustering = 0,
                  .dt = 0.002});
}

// Solved anew from the row of a table next to a value.
void expect_row(const std::string& file, CurveParameter parameter, double value) {
  const CsvTable table((test::source_folder() / "data/reference/pennon" / file).string());
  const FlagParameters flag{.mu = 1, .K_B = 1e-4, .gamma = {}};
  Linearisations linearisations(flag, {.Re = 1000}, settings(), parameter, umfpack_factors());
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (std::abs(*table.number(row, table.column(name(parameter))) - value) > 1e-9) continue;
    Linearisation linearised = linearisations.at(value);
    const double mu = *table.number(row, table.column("mu_cr")),
                 omega = *table.number(row, table.column("omega"));
    const auto mode = neutral_mode(linearised.aerodynamics(), linearised.flag, omega, mu);
    ASSERT_TRUE(mode) << table.place(row);
    EXPECT_NEAR(mode->mu, mu, 1e-7 * mu) << table.place(row);
    EXPECT_NEAR(mode->omega, omega, 1e-5) << table.place(row);
    return;
  }
  FAIL() << file << " has no row at " << value;
}

TEST(GlobalNeutralCurves, OverTheReynoldsNumberHaveTheKeptValueAtThatOfThePaper) {
  expect_row("neutral_over_Re.csv", CurveParameter::Re, 1000);
}

TEST(GlobalNeutralCurves, OverTheSpanwiseWavenumberBeginWithThatOfTwoDimensions) {
  expect_row("neutral_over_k_x.csv", CurveParameter::k_x, 0);
}

TEST(GlobalNeutralCurves, OverTheBendingStiffnessHaveThatOfTheCurveOverTheReynoldsNumber) {
  expect_row("neutral_over_K_B.csv", CurveParameter::K_B, 1e-4);
}

}  // namespace
}  // namespace pennon::modes::global

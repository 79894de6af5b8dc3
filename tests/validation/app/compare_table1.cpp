// Every case of Table 1 by the local theory, the global modes and the simulation. Kept under
// data/reference/pennon.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/io/csv.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon {
namespace {

using nlohmann::json;

double number_of(const json& value) {
  return value.is_number() ? value.get<double>() : NAN;
}

// Of the limit cycle of the kept run, if there is one.
double of_kept_run(const std::string& name, const char* quantity) {
  const std::filesystem::path file = test::source / "data/reference/pennon/runs" / (name + ".json");
  if (!std::filesystem::exists(file)) return NAN;
  return number_of(json::parse(test::read_text(file)).at("analyze").at("limit_cycle").at(quantity));
}

// 1: the wave travels with the cross-flow, -1 against it.
double direction_of(const json& global) {
  const json& with_U = global.at("travels_with_cross_flow");
  if (!with_U.is_boolean()) return NAN;
  return with_U.get<bool>() ? 1 : -1;
}

class CompareTable1 : public test::Commands {};

TEST_F(CompareTable1, SetsTheModelsOfEveryCaseSideBySide) {
  const CsvTable paper(test::source / "data/reference/table1.csv");
  std::vector<std::vector<double>> rows, seconds;
  for (std::size_t row = 0; row < paper.rows(); ++row) {
    const std::string name = paper.text(row, paper.column("case"));
    const bool is_unstable = paper.text(row, paper.column("lsa")) == "U";
    const test::Outcome outcome =
        pennon({"compare", (test::source / "data/cases/table1" / (name + ".toml")).string(),
                "--json", "--quiet", "--force", "--output", results()});
    ASSERT_EQ(outcome.status, test::done) << name << outcome.err;
    const json models = json::parse(outcome.out).at("compare");
    bool grows = false;
    for (const json& local : models) {
      if (local.at("model") != "local") continue;
      const auto global = std::ranges::find_if(models, [&](const json& other) {
        return other.at("model") == "global" && other.at("waves") == local.at("waves");
      });
      grows = grows || global->at("unstable") == true;
      const auto number = static_cast<double>(row + 1);
      rows.push_back({number, number_of(local.at("waves")), is_unstable ? 1.0 : 0.0,
                      number_of(local.at("growth")), number_of(local.at("frequency")),
                      number_of(global->at("growth")), number_of(global->at("frequency")),
                      direction_of(*global), of_kept_run(name, "A_over_L"),
                      of_kept_run(name, "f_s")});
      seconds.push_back({number, number_of(local.at("waves")), number_of(local.at("wall_s")),
                         number_of(global->at("wall_s"))});
    }
    // The paper's flags flap where a global mode grows, with or without waves along the span.
    EXPECT_TRUE(grows || !is_unstable) << name;
  }
  test::expect_reference(
      "compare_table1.csv",
      "the rows of data/reference/table1.csv by number; waves along the span; the table's verdict, "
      "1 unstable; growth rate and frequency in the local theory (k_y = pi, added mass wu) and of "
      "the global mode of flag or wake that grows most, 1 where that wave travels with the "
      "cross-flow and -1 where "
      "against it; amplitude and frequency of the kept run's limit cycle; "
      "tests/validation/app/compare_table1.cpp",
      {"row", "waves", "paper_unstable", "sigma_local", "f_local", "sigma_global", "f_global",
       "with_U", "A_over_L", "f_s"},
      rows, 0.01);
  if (std::getenv("PENNON_WRITE_REFERENCE"))
    test::expect_reference(
        "compare_table1_seconds.csv",
        "seconds that the local theory and the global modes took for the rows of "
        "compare_table1.csv, on one core; tests/validation/app/compare_table1.cpp",
        {"row", "waves", "local_s", "global_s"}, seconds, 0);
}

}  // namespace
}  // namespace pennon

#include "app/compare_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"

namespace pennon::app {
namespace {

using Json = nlohmann::ordered_json;

std::string verdict(const ComparedModel& row) {
  if (!row.is_unstable) return "-";
  return *row.is_unstable ? "unstable" : "stable";
}

std::string direction(const ComparedModel& row) {
  if (!row.travels_with_U) return "";
  return *row.travels_with_U ? "   with the cross-flow" : "   against the cross-flow";
}

template <class Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

}  // namespace

Json to_json(const std::vector<ComparedModel>& rows) {
  Json json = Json::array();
  for (const ComparedModel& row : rows)
    json.push_back({{"model", row.model},
                    {"waves", or_null(row.waves)},
                    {"growth", or_null(row.growth)},
                    {"frequency", or_null(row.frequency)},
                    {"unstable", or_null(row.is_unstable)},
                    {"travels_with_cross_flow", or_null(row.travels_with_U)},
                    {"wall_s", row.wall_seconds}});
  return json;
}

std::string text_of(const std::vector<ComparedModel>& rows) {
  std::string text = "  model    waves      growth   frequency   verdict     seconds\n";
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{:.4g}", *value) : std::string("-");
  };
  for (const ComparedModel& row : rows)
    text += fmt::format("  {:<8} {:>5} {:>11} {:>11}   {:<9} {:>9.3g}{}\n", row.model,
                        number(row.waves), number(row.growth), number(row.frequency), verdict(row),
                        row.wall_seconds, direction(row));
  return text;
}

void write_table(const std::vector<ComparedModel>& rows, const OutputFolder& folder) {
  CsvText table(
      "models of the same flag: growth rate and frequency of the mode that grows most, in "
      "V/L, of waves along the span; wall_s: what it took, in seconds",
      {"model", "verdict", "waves", "growth", "frequency", "wall_s"});
  for (const ComparedModel& row : rows)
    table.row({row.waves.value_or(NAN), row.growth.value_or(NAN), row.frequency.value_or(NAN),
               row.wall_seconds},
              {row.model, verdict(row)});
  write_file(folder / "compare.csv", table.text());
}

}  // namespace pennon::app

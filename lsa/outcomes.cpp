#include "lsa/outcomes.hpp"

#include <fmt/format.h>

#include <numbers>

#include "common/case/parameters.hpp"
#include "common/errors.hpp"
#include "common/io/csv.hpp"

namespace pennon::lsa {
namespace {

double within(const CsvTable& table, std::size_t row, const std::string& column, double value,
              const Range& range) {
  if (!range.contains(value))
    throw InputError(table.place(row),
                     fmt::format("{} must be {}, but is {}", column, range.text(), value));
  return value;
}

}  // namespace

double Outcome::k_x() const {
  return gamma ? 2 * std::numbers::pi / *gamma : 0.0;
}

std::vector<Outcome> read_outcomes(const std::filesystem::path& path) {
  const CsvTable table(path);
  std::vector<Outcome> outcomes;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto mu = table.number(row, table.column("mu"));
    if (!mu) throw InputError(table.place(row), "mu is missing");
    auto gamma = table.number(row, table.column("gamma"));
    if (gamma) within(table, row, "gamma", *gamma, ranges::gamma);
    const std::string& verdict = table.text(row, table.column("lsa"));
    if (verdict != "S" && verdict != "U")
      throw InputError(table.place(row),
                       fmt::format("lsa must be S (stable) or U (unstable), but is "
                                   "\"{}\"",
                                   verdict));
    outcomes.push_back({table.text(row, table.column("case")),
                        within(table, row, "mu", *mu, ranges::mu), gamma,
                        table.number(row, table.column("U_over_V")).value_or(0), verdict == "U"});
  }
  if (outcomes.empty()) throw InputError(path.string(), "has no rows");
  return outcomes;
}

Point at(Point point, const Outcome& outcome) {
  point.mu = outcome.mu;
  point.k_x = outcome.k_x();
  point.U = outcome.U;
  return point;
}

}  // namespace pennon::lsa

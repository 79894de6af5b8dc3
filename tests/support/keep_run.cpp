/// Keeps what a coupled run said, as small data:  keep_run RESULTS NAME
///
/// RESULTS: the folder of a case's results, with those of `pennon dns` and `pennon analyze` in dns
/// and analysis. Leaves, under
/// data/reference/pennon/runs, NAME.csv (a row every 0.05 L/V: the trailing edge and its waves
/// along the span, forces, energies), NAME.json (what the analysis found) and NAME.toml (the case
/// that reruns it).
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "common/io/csv.hpp"
#include "tests/support/source_folder.hpp"
#include "tests/support/text_file.hpp"
#include "tests/support/tool.hpp"

namespace pennon {
namespace {

constexpr double interval = 0.05;
constexpr int most_waves = 6;

// Five significant digits, which is more than a run repeats on another machine.
double rounded(double value) {
  return std::isfinite(value) ? std::stod(fmt::format("{:.4e}", value)) : value;
}

struct Source {
  CsvTable table;
  std::vector<std::string> columns;
};

std::vector<Source> sources_of(const std::filesystem::path& results) {
  std::vector<Source> sources;
  sources.push_back({CsvTable(results / "analysis/spanwise_amplitudes.csv"), {"z_antinode"}});
  for (int n = 0; n < most_waves; ++n)
    if (const std::string zeta_n = fmt::format("zeta_{}", n); sources.back().table.has(zeta_n))
      sources.back().columns.push_back(zeta_n);
  sources.push_back({CsvTable(results / "dns/history.csv"), {"C_D", "C_L"}});
  sources.push_back({CsvTable(results / "analysis/energy.csv"),
                     {"fluid", "flag_kinetic", "bending", "stretch", "E_t", "defect"}});
  return sources;
}

std::string thinned(const std::filesystem::path& results) {
  const std::vector<Source> sources = sources_of(results);
  std::vector<std::string> columns = {"t"};
  for (const Source& source : sources)
    columns.insert(columns.end(), source.columns.begin(), source.columns.end());
  CsvText text(
      "z_antinode, |zeta_n|: of the trailing edge, in L; energies and defect per span, in rho_f "
      "V^2 L^2; E_t: as in the paper's Table 2; t in L/V; every 0.05",
      columns);
  const auto number = [](const Source& source, std::size_t row, const std::string& column) {
    return source.table.number(row, source.table.column(column)).value_or(NAN);
  };
  double next = 0;
  for (std::size_t row = 0; row < sources.front().table.rows(); ++row) {
    const double t = number(sources.front(), row, "t");
    if (t < next) continue;
    next = interval * (std::floor(t / interval) + 1);
    std::vector<double> numbers = {rounded(t)};
    for (const Source& source : sources)
      for (const std::string& column : source.columns)
        numbers.push_back(rounded(number(source, row, column)));
    text.row(numbers);
  }
  return text.text();
}

void keep(char** argv) {
  const std::filesystem::path results = argv[1];
  const std::filesystem::path kept = test::source_folder() / "data/reference/pennon/runs";
  const std::string name = argv[2];
  std::filesystem::create_directories(kept);
  test::write_text(kept / (name + ".csv"), thinned(results));
  const auto copy = [&](const char* from, const char* ending) {
    std::filesystem::copy_file(results / from, kept / (name + ending),
                               std::filesystem::copy_options::overwrite_existing);
  };
  copy("analysis/summary.json", ".json");
  copy("dns/case.resolved.toml", ".toml");
}

}  // namespace
}  // namespace pennon

int main(int argc, char** argv) {
  return pennon::test::run_tool(argc, argv, 3, "keep_run RESULTS NAME", pennon::keep);
}

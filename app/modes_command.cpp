#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <filesystem>
#include <numbers>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "app/global_neutral.hpp"
#include "app/global_process.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "modes/normal/study.hpp"

namespace pennon::app {
namespace {

constexpr std::size_t most_modes_shown = 30;

std::string text_of(const modes::Result& result) {
  std::string text = "   n    m         k_x       alpha       omega   frequency\n";
  const auto& list = result.modes.modes;
  for (std::size_t i = 0; i < std::min(list.size(), most_modes_shown); ++i)
    text += fmt::format("{:4} {:4} {:11.6g} {:11.6g} {:11.6g} {:11.6g}\n", list[i].n, list[i].m,
                        list[i].k_x, list[i].alpha, list[i].omega,
                        list[i].omega / (2 * std::numbers::pi));
  if (list.size() > most_modes_shown)
    text += fmt::format("  and {} more in modes.csv\n", list.size() - most_modes_shown);
  return text;
}

nlohmann::ordered_json to_json(const modes::Decomposition& decomposition) {
  nlohmann::ordered_json json = {{"truncation_error", decomposition.truncation_error}};
  for (const modes::Amplitude& a : decomposition.amplitudes)
    json["amplitudes"].push_back({{"n", a.n}, {"m", a.m}, {"A", a.A}, {"B", a.B}});
  if (decomposition.fit) json["condition_number"] = decomposition.fit->condition_number;
  return json;
}

std::vector<double> shape_row(std::size_t mode, double y, std::complex<double> zeta) {
  const auto at = [&](double degrees) {
    return (zeta * std::polar(1.0, degrees * std::numbers::pi / 180)).real();
  };
  return {static_cast<double>(mode), y, zeta.real(), zeta.imag(), at(45), at(90), at(135)};
}

// Shapes along the chord and eigenvalues of what pennon-global found.
void write_global_tables(const nlohmann::ordered_json& found, const OutputFolder& folder) {
  CsvText spectrum("global modes exp(lambda t): growth and angular frequency in V/L",
                   {"growth", "omega", "frequency", "residual"});
  for (const auto& mode : found["global"]["modes"])
    spectrum.row({mode["growth"], mode["omega"], mode["frequency"], mode["residual"]});
  write_file(folder / "global_modes.csv", spectrum.text());
  CsvText shapes(
      "displacement of the flag in its global modes, 1 where it is largest, and at phases in "
      "degrees (at 0 it is zeta_real); y in L",
      {"mode", "y", "zeta_real", "zeta_imag", "at_45", "at_90", "at_135"});
  for (std::size_t m = 0; m < found["zeta"].size(); ++m)
    for (std::size_t j = 0; j < found["y"].size(); ++j)
      shapes.row(shape_row(m + 1, found["y"][j], {found["zeta"][m][j][0], found["zeta"][m][j][1]}));
  write_file(folder / "global_shapes.csv", shapes.text());
}

std::string text_of_global(const nlohmann::ordered_json& found) {
  const nlohmann::ordered_json& global = found["global"];
  const nlohmann::ordered_json& base = global["base_flow"];
  std::string text = fmt::format(
      "  global modes: {} of {} converged; steady flow: drag coefficient {:.6g}, tension at the "
      "leading edge {:.6g}\n      growth       omega   frequency  residual\n",
      global["converged"].get<int>(), global["requested"].get<int>(),
      base["drag_coefficient"].get<double>(), base["tension_leading_edge"].get<double>());
  for (const auto& mode : global["modes"])
    text += fmt::format(" {:11.6g} {:11.6g} {:11.6g}   {:.1e}\n", mode["growth"].get<double>(),
                        mode["omega"].get<double>(), mode["frequency"].get<double>(),
                        mode["residual"].get<double>());
  return text;
}

// Of an earlier run, which may have had more modes, or adjoints.
void remove_pictures_of_modes(const OutputFolder& folder) {
  std::vector<std::filesystem::path> old;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
    if (entry.path().filename().string().starts_with("global_modes_mode_")) old.push_back(entry);
  for (const std::filesystem::path& picture : old) std::filesystem::remove(picture);
}

nlohmann::ordered_json global_modes(const Case& the_case, const OutputFolder& folder) {
  const modes::global::Problem problem(the_case.flag, the_case.flow, the_case.global_modes);
  nlohmann::ordered_json found = solve_global_modes(problem, folder);
  if (!found["global"]["modes"].empty()) {
    write_global_tables(found, folder);
    remove_pictures_of_modes(folder);
    analysis::plot(folder / "global_modes.h5");
  }
  return found;
}

}  // namespace

void run_modes(const Options& options) {
  const auto expect = [](const Case& the_case) {
    if (the_case.global_modes.is_given) expect_one_rank();
  };
  const auto work = [](const Case& the_case, const OutputFolder& folder, Record& record) {
    const modes::Result result = [&] {
      const auto timer = record.time("modes");
      return modes::run(the_case.modes, the_case.flag, the_case.flow);
    }();
    {
      const auto timer = record.time("output");
      write(result, folder);
      analysis::plot(folder / "modes.h5");
    }
    nlohmann::ordered_json json = {{"normal", modes::to_json(result)}};
    std::string text = fmt::format("{}: normal modes, {}\n{}", the_case.name,
                                   name_of(result.modes.family), text_of(result));
    if (result.decomposition) {
      json["decomposition"] = to_json(*result.decomposition);
      text += fmt::format("  decomposition: truncation error {:.3g}\n",
                          result.decomposition->truncation_error);
    }
    if (the_case.global_modes.is_given) {
      const auto global_timer = record.time("global modes");
      const nlohmann::ordered_json found = global_modes(the_case, folder);
      json["global"] = found["global"];
      text += text_of_global(found);
      if (the_case.global_modes.neutral.is_given) {
        write_neutral_curve(found["global"], the_case, folder);
        text += text_of_neutral_curve(found["global"]);
      }
      if (the_case.global_modes.map.is_given) {
        write_growth_map(found["map"], the_case, folder);
        json["global"]["map"] = summary_of_map(found["map"]);
        text += text_of_growth_map(found["map"], the_case.global_modes.map.lambda_tolerance);
      }
    }
    return Answer{json, text};
  };
  run({{.modes = true}, expect, work}, options);
}

}  // namespace pennon::app

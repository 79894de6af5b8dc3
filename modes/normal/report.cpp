#include "modes/normal/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <numbers>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::modes {
namespace {

double frequency(const NormalMode& mode) {
  return mode.omega / (2 * std::numbers::pi);
}

std::string table_text(const NormalModes& family) {
  CsvText table("normal modes without fluid loading; k_x in 1/L, omega and frequency in V/L",
                {"family", "n", "m", "k_x", "alpha", "omega", "frequency"});
  for (const NormalMode& mode : family.modes)
    table.row({static_cast<double>(mode.n), static_cast<double>(mode.m), mode.k_x, mode.alpha,
               mode.omega, frequency(mode)},
              {name_of(family.family)});
  return table.text();
}

std::string decomposition_text(const Decomposition& decomposition) {
  std::string comment = fmt::format(
      "amplitudes in L of cos (A) and sin (B); truncation error {:.3e}, relative to the "
      "norm of the displacement",
      decomposition.truncation_error);
  if (decomposition.fit)
    comment += fmt::format("; least squares of {} samples, condition number {:.3g}",
                           decomposition.fit->samples, decomposition.fit->condition_number);
  CsvText table(comment, {"n", "m", "A", "B"});
  for (const Amplitude& amplitude : decomposition.amplitudes)
    table.row({static_cast<double>(amplitude.n), static_cast<double>(amplitude.m), amplitude.A,
               amplitude.B});
  return table.text();
}

void write_shapes(const Result& result, const std::filesystem::path& file) {
  const std::vector<NormalMode>& modes = result.modes.modes;
  hdf5::Writer writer(file);
  writer.attributes(
      {{"kind", std::string("normal_modes")}, {"family", name_of(result.modes.family)}});
  const auto about = [](const char* meaning, const char* unit) {
    return hdf5::Attributes{{"meaning", std::string(meaning)}, {"unit", std::string(unit)}};
  };
  const auto write_each = [&](const char* name, auto value, const hdf5::Attributes& attributes) {
    std::vector<double> values;
    values.reserve(modes.size());
    for (const NormalMode& mode : modes) values.push_back(static_cast<double>(value(mode)));
    writer.write(name, {modes.size()}, values, attributes);
  };
  write_each(
      "n", [](const NormalMode& mode) { return mode.n; }, about("waves along the span", "1"));
  write_each(
      "m", [](const NormalMode& mode) { return mode.m; }, about("rank along the chord", "1"));
  write_each(
      "k_x", [](const NormalMode& mode) { return mode.k_x; }, about("spanwise wavenumber", "1/L"));
  write_each(
      "alpha", [](const NormalMode& mode) { return mode.alpha; },
      about("omega/c, c^2 = 1.3 Re^-1/2/mu; hanging_chain: the zero of J_0", "1"));
  write_each(
      "omega", [](const NormalMode& mode) { return mode.omega; },
      about("angular frequency", "V/L"));
  writer.write("y", {result.y.size()}, result.y, about("distance from the leading edge", "L"));
  std::vector<double> all;
  for (const std::vector<double>& shape : result.shapes)
    all.insert(all.end(), shape.begin(), shape.end());
  writer.write("shapes", {modes.size(), result.y.size()}, all,
               about("chordwise shape Y of each mode at y", "1"));
  writer.finish();
}

}  // namespace

void write_tables(const Result& result, const OutputFolder& folder) {
  write_file(folder / "modes.csv", table_text(result.modes));
  write_shapes(result, folder / "modes.h5");
  if (result.decomposition)
    write_file(folder / "decomposition.csv", decomposition_text(*result.decomposition));
}

nlohmann::ordered_json to_json(const Result& result) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const NormalMode& mode : result.modes.modes)
    list.push_back({{"family", name_of(result.modes.family)},
                    {"n", mode.n},
                    {"m", mode.m},
                    {"k_x", mode.k_x},
                    {"alpha", mode.alpha},
                    {"omega", mode.omega},
                    {"frequency", frequency(mode)}});
  return list;
}

nlohmann::ordered_json to_json(const Decomposition& decomposition) {
  nlohmann::ordered_json json = {{"truncation_error", decomposition.truncation_error}};
  for (const Amplitude& a : decomposition.amplitudes)
    json["amplitudes"].push_back({{"n", a.n}, {"m", a.m}, {"A", a.A}, {"B", a.B}});
  if (decomposition.fit) json["condition_number"] = decomposition.fit->condition_number;
  return json;
}

std::string text_of(const Result& result) {
  constexpr std::size_t most_modes_shown = 30;
  std::string text = "   n    m         k_x       alpha       omega   frequency\n";
  const std::vector<NormalMode>& list = result.modes.modes;
  for (std::size_t i = 0; i < std::min(list.size(), most_modes_shown); ++i)
    text += fmt::format("{:4} {:4} {:11.6g} {:11.6g} {:11.6g} {:11.6g}\n", list[i].n, list[i].m,
                        list[i].k_x, list[i].alpha, list[i].omega, frequency(list[i]));
  if (list.size() > most_modes_shown)
    text += fmt::format("  and {} more in modes.csv\n", list.size() - most_modes_shown);
  if (result.decomposition)
    text += fmt::format("  decomposition: truncation error {:.3g}\n",
                        result.decomposition->truncation_error);
  return text;
}

}  // namespace pennon::modes

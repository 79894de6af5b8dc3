#include "modes/normal/study.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <numbers>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "modes/normal/bessel.hpp"
#include "modes/normal/hanging_chain.hpp"
#include "modes/normal/initial_shape.hpp"

namespace pennon::modes {
namespace {

NormalModes modes_of(const Settings& settings, const FlagParameters& flag,
                     const FlowParameters& flow) {
  const ModeRange range = mode_range(settings, flag);
  switch (settings.family) {
    case Family::bessel:
      return bessel_modes(range, flag, flow);
    case Family::hanging_chain:
      return hanging_chain_modes(range, flag, flow);
    case Family::in_vacuo:
      break;
  }
  return in_vacuo_modes(range, flag, flow, settings.tension, static_cast<int>(settings.elements));
}

Decomposition decomposition_of(const DecomposeSettings& settings, const NormalModes& family) {
  if (!settings.samples.empty())
    return decompose(family, read_samples(settings.samples, family.gamma.has_value()),
                     settings.samples);
  const InitialShape shape(settings.A, settings.B, family.gamma);
  return decompose(family, shape, shape.largest_wave());
}

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

Result run(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow) {
  Result result{modes_of(settings, flag, flow), {}, {}, std::nullopt};
  const auto last = static_cast<double>(settings.shape_points - 1);
  for (std::int64_t i = 0; i < settings.shape_points; ++i)
    result.y.push_back(static_cast<double>(i) / last);
  for (const NormalMode& mode : result.modes.modes) {
    std::vector<double>& shape = result.shapes.emplace_back();
    for (const double y : result.y) shape.push_back(mode.shape(y));
  }
  if (settings.decompose.is_given)
    result.decomposition = decomposition_of(settings.decompose, result.modes);
  return result;
}

void write(const Result& result, const OutputFolder& folder) {
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

}  // namespace pennon::modes

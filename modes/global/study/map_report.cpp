#include "modes/global/study/map_report.hpp"

#include <fmt/format.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"

namespace pennon::modes::global {
namespace {

std::size_t points(const GrowthMap& map) {
  return map.x.size() * map.mu.size();
}

// The rows of a field one behind the other.
std::vector<double> joined(const std::vector<std::vector<double>>& rows) {
  std::vector<double> values;
  for (const std::vector<double>& row : rows) values.insert(values.end(), row.begin(), row.end());
  return values;
}

// For each x the smallest mass ratio of a neutral mode, NaN where it does not lie on the map.
std::vector<double> neutral_curve_of(const GrowthMap& map) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> mu;
  mu.reserve(map.neutral.size());
  for (const std::vector<double>& neutral : map.neutral) {
    const double lowest = neutral.empty() ? none : neutral.front();
    mu.push_back(lowest <= map.mu.back() ? lowest : none);
  }
  return mu;
}

}  // namespace

nlohmann::ordered_json to_json(const GrowthMap& map) {
  return {{"points", points(map)},
          {"basis_size", map.basis_size},
          {"fit_error", map.fit_error},
          {"basis_error", map.basis_error},
          {"checked_basis", map.checked_basis},
          {"lambda_error", map.lambda_error},
          {"checked", map.checked},
          {"samples", map.samples},
          {"samples_off_axis", map.samples_off_axis},
          {"sample_s", map.sample_seconds},
          {"map_s", map.map_seconds}};
}

void write_tables(const GrowthMap& map, const OutputFolder& folder) {
  CsvText table("growth rate and angular frequency in V/L of the global mode that grows most",
                {name(map.parameter), "mu", "growth", "omega"});
  for (std::size_t m = 0; m < map.mu.size(); ++m)
    for (std::size_t i = 0; i < map.x.size(); ++i)
      table.row({map.x[i], map.mu[m], map.growth[m][i], map.omega[m][i]});
  write_file(folder / "global_map.csv", table.text());
}

std::string text_of(const GrowthMap& map, double lambda_tolerance) {
  std::string text = fmt::format(
      "  growth map: {} points in {:.3g} s after {} samples of the response in {:.3g} s, in a "
      "basis "
      "of {} shapes\n"
      "  error of lambda: {:.1e} at {} points by the response itself, {:.1e} at {} points by the "
      "whole flag\n",
      points(map), map.map_seconds, map.samples, map.sample_seconds, map.basis_size,
      map.lambda_error, map.checked, map.basis_error, map.checked_basis);
  if (map.lambda_error > lambda_tolerance)
    text += fmt::format(
        "  which is more than modes.global.map.lambda_tolerance = {:.1e}; a smaller fit_tolerance, "
        "or fewer mass ratios at which the modes decay fast, may help\n",
        lambda_tolerance);
  return text;
}

void write_hdf5(const GrowthMap& map, const MapPicture& picture,
                const std::filesystem::path& path) {
  hdf5::Writer file(path);
  file.attributes({{"kind", "global_map"}, {"title", picture.title}, {"picture", "growth"}});
  file.write("/x", {map.x.size()}, map.x, picture.x_axis);
  file.write("/y", {map.mu.size()}, map.mu, picture.mu_axis);
  file.write("/fields/growth", {map.mu.size(), map.x.size()}, joined(map.growth),
             {{"name", "growth"},
              {"meaning", "growth rate of the global mode that grows most, in V/L"},
              {"label", "growth rate {/:Italic σL}/{/:Italic V}"},
              {"is_signed", std::int64_t{0}}});
  file.write("/fields/omega", {map.mu.size(), map.x.size()}, joined(map.omega),
             {{"name", "omega"},
              {"meaning", "its angular frequency, in V/L"},
              {"label", "{/:Italic ωL}/{/:Italic V}"},
              {"is_signed", std::int64_t{0}}});
  file.write("/neutral/x", {map.x.size()}, map.x, {{"label", "neutral curve"}});
  file.write("/neutral/y", {map.x.size()}, neutral_curve_of(map));
  write(picture.outcomes, file);
  file.finish();
}

}  // namespace pennon::modes::global

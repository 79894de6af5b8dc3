#include "analysis/decomposition/report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"

namespace pennon::decomposition {
namespace {

using Eigen::Index;
using Json = nlohmann::ordered_json;

constexpr double two_pi = 2 * std::numbers::pi;

std::size_t shown_of(const Decomposition& found, std::size_t there) {
  return std::min(there, found.n_modes);
}

// Of real data the two modes of a pair are one oscillation, of which the one with omega > 0 is
// shown.
bool is_shown(const Decomposition& found, const DmdMode& mode) {
  constexpr double rounding = 1e-9;
  return found.is_complex || mode.lambda.imag() * found.times.dt > -rounding;
}

std::vector<DmdMode> shown_modes(const Decomposition& found) {
  std::vector<DmdMode> shown;
  for (const DmdMode& mode : found.dmd->modes)
    if (is_shown(found, mode)) shown.push_back(mode);
  shown.resize(shown_of(found, shown.size()));
  return shown;
}

std::vector<double> shares(const Decomposition& found) {
  std::vector<double> values;
  for (const double energy : found.pod->energy) values.push_back(energy / found.variance);
  return values;
}

void add_pod(const Decomposition& found, Json& json) {
  const std::size_t shown = shown_of(found, static_cast<std::size_t>(found.pod->energy.size()));
  const std::vector<double> energy(found.pod->energy.begin(),
                                   found.pod->energy.begin() + static_cast<std::ptrdiff_t>(shown));
  std::vector<double> share = shares(found);
  share.resize(shown);
  json["energy"] = energy;
  json["share"] = share;
}

void add_dmd(const Decomposition& found, Json& json) {
  json["rank"] = found.dmd->rank;
  json["variant"] = found.settings.variant == DmdVariant::exact ? "exact" : "optimised";
  json["misfit"] = nullptr;
  if (std::isfinite(found.dmd->misfit)) json["misfit"] = found.dmd->misfit;
  json["modes"] = Json::array();
  for (const DmdMode& mode : shown_modes(found))
    json["modes"].push_back({{"growth", mode.lambda.real()},
                             {"omega", mode.lambda.imag()},
                             {"frequency", mode.lambda.imag() / two_pi},
                             {"growth_error", mode.growth_error},
                             {"omega_error", mode.omega_error},
                             {"amplitude", mode.amplitude},
                             {"residual", mode.residual}});
}

void add_spod(const Decomposition& found, Json& json) {
  const Spod& spod = found.spod->spod;
  json["block"] = spod.blocks.length;
  json["blocks"] = spod.blocks.count();
  json["independent_blocks"] = spod.independent_blocks;
  json["f"] = spod.f;
  json["energy"] = Json::array();
  json["interval"] = Json::array();
  for (std::size_t f = 0; f < spod.f.size(); ++f) {
    const Eigen::VectorXd& energy = spod.energy[f];
    const auto shown = static_cast<Index>(shown_of(found, static_cast<std::size_t>(energy.size())));
    json["energy"].push_back(std::vector<double>(energy.begin(), energy.begin() + shown));
    const auto interval = energy_interval(spod, static_cast<Index>(f));
    Json high = nullptr;
    if (std::isfinite(interval[1])) high = interval[1] * energy(0);
    json["interval"].push_back({interval[0] * energy(0), high});
  }
  json["peaks"] = Json::array();
  for (const Index f : found.spod->kept)
    json["peaks"].push_back(spod.f[static_cast<std::size_t>(f)]);
}

void add_waves(const Decomposition& found, Json& json) {
  json["waves"] = Json::array();
  for (const SpanwiseWaveParts& wave : found.waves)
    json["waves"].push_back({{"n", wave.n},
                             {"k_x", wave.k_x},
                             {"standing", wave.standing()},
                             {"travelling", wave.travelling()},
                             {"amplitude", wave.amplitude()}});
}

// Root of the mean square of an amplitude.
double size_of(const Projection& projection, std::size_t mode) {
  return projection.a.row(static_cast<Index>(mode)).norm() /
         std::sqrt(static_cast<double>(projection.a.cols()));
}

Slopes slopes_of_mode(const Decomposition& found, std::size_t mode) {
  return slopes_of(found.times.t, found.projection->a.row(static_cast<Index>(mode)));
}

void add_projection(const Decomposition& found, Json& json) {
  const Projection& projection = *found.projection;
  json["error"] = projection.error();
  json["condition_number"] = projection.condition_number;
  json["modes"] = Json::array();
  for (std::size_t j = 0; j < projection.modes.size(); ++j) {
    const GivenMode& mode = projection.modes[j];
    const Slopes slopes = slopes_of_mode(found, j);
    Json one = {{"mode", mode.name},
                {"k_x", mode.k},
                {"amplitude", size_of(projection, j)},
                {"growth", slopes.growth},
                {"growth_error", slopes.growth_error},
                {"omega", nullptr},
                {"omega_error", nullptr},
                {"growth_of_mode", mode.lambda.real()},
                {"omega_of_mode", mode.lambda.imag()}};
    if (!mode.is_standing) {
      one["omega"] = slopes.omega;
      one["omega_error"] = slopes.omega_error;
    }
    json["modes"].push_back(std::move(one));
  }
}

std::string text_of_projection(const Decomposition& found) {
  const Projection& projection = *found.projection;
  std::string text = fmt::format(
      "  left of all shapes: {:.3g} of their norm; condition number {:.3g}\n"
      "  {:24} amplitude       growth +- error       omega +- error   the mode's own\n",
      projection.error(), projection.condition_number, "");
  for (std::size_t j = 0; j < projection.modes.size(); ++j) {
    const GivenMode& mode = projection.modes[j];
    const Slopes slopes = slopes_of_mode(found, j);
    text += fmt::format("  {:24} {:9.3g} {:12.5g} +- {:7.1e}", mode.name, size_of(projection, j),
                        slopes.growth, slopes.growth_error);
    text += mode.is_standing
                ? fmt::format("{:>23}", "-")
                : fmt::format(" {:11.5g} +- {:7.1e}", slopes.omega, slopes.omega_error);
    text += fmt::format("   {:.5g} {:+.5g} i\n", mode.lambda.real(), mode.lambda.imag());
  }
  return text;
}

std::string text_of_pod(const Decomposition& found) {
  std::string text = "  mode      energy     share  together\n";
  const std::vector<double> share = shares(found);
  double together = 0;
  for (std::size_t j = 0; j < shown_of(found, share.size()); ++j) {
    together += share[j];
    text += fmt::format("  {:4} {:11.4g} {:9.4g} {:9.6f}\n", j + 1,
                        found.pod->energy(static_cast<Index>(j)), share[j], together);
  }
  return text;
}

std::string text_of_dmd(const Decomposition& found) {
  std::string text = fmt::format("  rank {}{}\n", found.dmd->rank,
                                 found.settings.rank || found.dmd->rank < found.dmd->rank_of_signal
                                     ? ""
                                     : ", by the singular values above the noise");
  text += fmt::format("  misfit of all snapshots: {:.3g} of their norm\n", found.dmd->misfit);
  text += "        growth +- error          omega +- error    amplitude  residual\n";
  for (const DmdMode& mode : shown_modes(found))
    text += fmt::format("  {:13.6g} +- {:8.1e} {:12.6g} +- {:8.1e}  {:9.3g}  {:8.1e}\n",
                        mode.lambda.real(), mode.growth_error, mode.lambda.imag(), mode.omega_error,
                        mode.amplitude, mode.residual);
  return text;
}

std::string text_of_spod(const Decomposition& found) {
  const Spod& spod = found.spod->spod;
  std::string text = fmt::format(
      "  {} blocks of {} snapshots each, worth {:.3g} independent ones\n"
      "  highest first energies:\n         f     energy   95 % interval         "
      "share of f\n",
      spod.blocks.count(), spod.blocks.length, spod.independent_blocks);
  for (const Index index : found.spod->kept) {
    const auto f = static_cast<std::size_t>(index);
    const double first = spod.energy[f](0);
    const auto interval = energy_interval(spod, index);
    text += fmt::format("  {:8.4g} {:10.4g}   {:.3g} to {:.3g}   {:8.4f}\n", spod.f[f], first,
                        interval[0] * first, interval[1] * first, first / spod.energy[f].sum());
  }
  return text;
}

std::string text_of_waves(const Decomposition& found) {
  std::string text = "     n        k_x  amplitude   standing  travelling (> 0: along +x)\n";
  for (const SpanwiseWaveParts& wave : found.waves)
    text += fmt::format("  {:4} {:10.4g} {:10.4g} {:10.4g}  {:10.4g}\n", wave.n, wave.k_x,
                        wave.amplitude(), wave.standing(), wave.travelling());
  return text;
}

}  // namespace

nlohmann::ordered_json to_json(const Decomposition& found) {
  Json json = {{"method", name_of(found.settings.method)},
               {"source", found.layout.name},
               {"quantity", found.layout.quantity},
               {"snapshots", found.times.t.size()},
               {"values", found.layout.values()},
               {"from", found.times.t.front()},
               {"to", found.times.t.back()},
               {"dt", found.times.dt},
               {"resampled", found.times.is_resampled},
               {"variance", found.variance}};
  if (found.pod) add_pod(found, json);
  if (found.dmd) add_dmd(found, json);
  if (found.spod) add_spod(found, json);
  if (found.settings.method == Method::waves) add_waves(found, json);
  if (found.projection) add_projection(found, json);
  json["notes"] = found.notes;
  return json;
}

std::string text_of(const Decomposition& found) {
  std::string text = fmt::format(
      "{}: {}\n  {} snapshots of {} values from t = {:.6g} to {:.6g}, dt = {:.6g}; {} {:.6g}\n",
      found.layout.name, found.layout.quantity, found.times.t.size(), found.layout.values(),
      found.times.t.front(), found.times.t.back(), found.times.dt,
      found.settings.removes_mean() ? "variance" : "mean square", found.variance);
  if (found.pod) text += text_of_pod(found);
  if (found.dmd) text += text_of_dmd(found);
  if (found.spod) text += text_of_spod(found);
  if (found.settings.method == Method::waves) text += text_of_waves(found);
  if (found.projection) text += text_of_projection(found);
  return text;
}

void write_table(const Decomposition& found, const OutputFolder& folder) {
  std::string text;
  if (found.pod) {
    CsvText table("proper orthogonal modes: energy, and its share of the variance",
                  {"mode", "energy", "share"});
    const std::vector<double> share = shares(found);
    for (std::size_t j = 0; j < share.size(); ++j)
      table.row({static_cast<double>(j + 1), found.pod->energy(static_cast<Index>(j)), share[j]});
    text = table.text();
  }
  if (found.dmd) {
    CsvText table("dynamic modes; errors are one standard deviation",
                  {"growth", "omega", "growth_error", "omega_error", "amplitude", "residual"});
    for (const DmdMode& mode : found.dmd->modes)
      table.row({mode.lambda.real(), mode.lambda.imag(), mode.growth_error, mode.omega_error,
                 mode.amplitude, mode.residual});
    text = table.text();
  }
  if (found.spod) {
    const Spod& spod = found.spod->spod;
    std::vector<std::string> columns = {"f", "low", "high"};
    const std::size_t shown = shown_of(found, static_cast<std::size_t>(spod.energy.front().size()));
    for (std::size_t j = 0; j < shown; ++j) columns.push_back(fmt::format("energy_{}", j + 1));
    CsvText table(
        "spectral proper orthogonal modes: energies at each frequency; low, high: the 95 % "
        "interval "
        "of the first",
        columns);
    for (std::size_t f = 0; f < spod.f.size(); ++f) {
      const auto interval = energy_interval(spod, static_cast<Index>(f));
      std::vector<double> row = {spod.f[f], interval[0] * spod.energy[f](0),
                                 interval[1] * spod.energy[f](0)};
      row.insert(row.end(), spod.energy[f].begin(),
                 spod.energy[f].begin() + static_cast<Index>(shown));
      table.row(row);
    }
    text = table.text();
  }
  if (found.settings.method == Method::waves) {
    CsvText table(
        "waves along the span: amplitudes of cosines, in L, the middle of the snapshots counting "
        "most",
        {"n", "k_x", "amplitude", "standing", "travelling"});
    for (const SpanwiseWaveParts& wave : found.waves)
      table.row({static_cast<double>(wave.n), wave.k_x, wave.amplitude(), wave.standing(),
                 wave.travelling()});
    text = table.text();
  }
  if (found.projection) {
    std::vector<std::string> columns = {"t", "rest"};
    for (std::size_t j = 0; j < found.projection->modes.size(); ++j)
      for (const char* part : {"real", "imag"})
        columns.push_back(fmt::format("a_{}_{}", j + 1, part));
    CsvText table(
        "amplitudes of the modes, in the order of summary.json, and the norm of what is left",
        columns);
    for (std::size_t m = 0; m < found.times.t.size(); ++m) {
      const auto at = static_cast<Index>(m);
      std::vector<double> row = {found.times.t[m], found.projection->rest(at)};
      for (Index j = 0; j < found.projection->a.rows(); ++j) {
        row.push_back(found.projection->a(j, at).real());
        row.push_back(found.projection->a(j, at).imag());
      }
      table.row(row);
    }
    text = table.text();
  }
  write_file(folder / "decomposition.csv", text);
}

}  // namespace pennon::decomposition

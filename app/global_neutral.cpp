#include "app/global_neutral.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "analysis/figures/plot.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "lsa/axis_attributes.hpp"
#include "lsa/curve.hpp"
#include "lsa/outcome_points.hpp"
#include "lsa/outcomes.hpp"

namespace pennon::app {
namespace {

using Json = nlohmann::ordered_json;
using modes::global::CurveParameter;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

double number_or_nan(const Json& value) {
  return value.is_null() ? none : value.get<double>();
}

lsa::Axis axis_of(CurveParameter parameter) {
  switch (parameter) {
    case CurveParameter::Re:
      return lsa::Axis::Re;
    case CurveParameter::k_x:
      return lsa::Axis::k_x;
    case CurveParameter::K_B:
      return lsa::Axis::K_B;
    default:
      return lsa::Axis::nu_s;
  }
}

void write_tables(const Json& global, const OutputFolder& folder) {
  const std::string over = global["neutral_over"];
  CsvText curve(
      "critical mass ratio of the global modes; branch: which mode; residual: of the full "
      "operator; "
      "fit_error: of the response where all modes were sought; largest_growth, distance: of the "
      "full operator's leading modes at mu_cr",
      {over, "mu_cr", "omega", "branch", "residual", "fit_error", "largest_growth", "distance",
       "evaluations", "wall_s"});
  CsvText branches(
      "neutral global modes; growth_by_mu: what a little more mu adds to the growth rate",
      {over, "branch", "mu", "omega", "growth_by_mu", "residual"});
  for (const Json& point : global["neutral"]) {
    curve.row({point[over], point["mu_cr"], point["omega"], point["branch"], point["residual"],
               number_or_nan(point["fit_error"]), number_or_nan(point["largest_growth"]),
               number_or_nan(point["distance"]), point["evaluations"], point["wall_s"]});
    for (const Json& mode : point["modes"])
      branches.row({point[over], mode["branch"], mode["mu"], mode["omega"], mode["growth_by_mu"],
                    mode["residual"]});
  }
  write_file(folder / "global_neutral.csv", curve.text());
  write_file(folder / "global_neutral_branches.csv", branches.text());
}

// mu of each branch at each point, NaN where it was not found.
void write_branches(const Json& points, hdf5::Writer& file) {
  std::map<int, std::vector<double>> mu;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const Json& mode : points[i]["modes"]) {
      std::vector<double>& row = mu[mode["branch"]];
      row.resize(points.size(), none);
      row[i] = mode["mu"];
    }
  std::vector<double> values;
  for (const auto& [branch, row] : mu) values.insert(values.end(), row.begin(), row.end());
  file.write("/branches", {mu.size(), points.size()}, values,
             {{"meaning", "mass ratio of each neutral mode that was followed"}});
}

// The local theory's curve for each added mass, where it knows the parameter.
void write_local_theory(const Case& the_case, const std::vector<double>& values,
                        hdf5::Writer& file) {
  const CurveParameter over = parameter(the_case.global_modes.neutral);
  lsa::Theory theory = the_case.lsa.theory;
  if (values.size() < 2 || (over == CurveParameter::K_B && !theory.model.bending)) return;
  constexpr std::int64_t points = 250;
  constexpr double first_share = 1.0 / points;  // from 0 the added mass of Wu has no limit
  lsa::CurveSettings curve;
  curve.is_given = true;
  curve.sweeps[static_cast<std::size_t>(axis_of(over))] =
      Sweep{.from = values.front() > 0 ? values.front() : first_share * values.back(),
            .to = values.back(),
            .points = points,
            .scale = sweep(the_case.global_modes.neutral).scale,
            .list = {}};
  lsa::Point point = lsa::point_of(the_case.flag, the_case.flow, the_case.lsa);
  point.k_x = *the_case.global_modes.k_x;
  constexpr std::array names = {"two_d", "wu", "lamb", "minami"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    theory.model.added_mass = static_cast<lsa::AddedMass>(i);
    const lsa::Curve found = lsa::compute(curve, point, theory);
    const std::string group = fmt::format("/local/{}", names[i]);
    file.write(group + "/x", {found.x.size()}, found.x);
    file.write(group + "/y", {found.x.size()}, found.values[0]);
  }
}

// The outcomes without cross-flow that lie on the picture; those of the table are at the Reynolds
// number of the case.
void write_marks(const Case& the_case, CurveParameter over, hdf5::Writer& file) {
  if (!the_case.lsa.marks.is_given) return;
  lsa::OutcomePoints marks;
  for (const lsa::Outcome& outcome : lsa::read_outcomes(the_case.lsa.marks.table)) {
    constexpr double same = 1e-9;
    const bool is_of_this_wave = std::abs(outcome.k_x() - *the_case.global_modes.k_x) < same;
    if (outcome.U != 0) continue;
    if (over == CurveParameter::k_x)
      marks.add(outcome.k_x(), outcome.mu, outcome.is_unstable);
    else if (over == CurveParameter::Re && is_of_this_wave)
      marks.add(the_case.flow.Re, outcome.mu, outcome.is_unstable);
  }
  lsa::write(marks, file);
}

}  // namespace

void write_neutral_curve(const Json& global, const Case& the_case, const OutputFolder& folder) {
  write_tables(global, folder);
  const Json& points = global["neutral"];
  if (points.empty()) return;
  const modes::global::NeutralSettings& settings = the_case.global_modes.neutral;
  const lsa::Axis axis = axis_of(parameter(settings));
  std::vector<double> x, mu;
  for (const Json& point : points) {
    x.push_back(point[name(axis)]);
    mu.push_back(point["mu_cr"]);
  }
  const std::filesystem::path path = folder / "global_neutral.h5";
  {
    hdf5::Writer file(path);
    file.attributes({{"kind", "global_neutral"}, {"title", settings.title}});
    file.write("/x", {x.size()}, x, attributes(axis, sweep(settings).scale));
    file.write(
        "/mu_cr", {mu.size()}, mu,
        {{"meaning", "critical mass ratio of the global modes"}, {"label", "{/:Italic μ}_{cr}"}});
    write_branches(points, file);
    write_local_theory(the_case, x, file);
    write_marks(the_case, parameter(settings), file);
    file.finish();
  }
  analysis::plot(path);
}

void write_growth_map(const Json& map, const Case& the_case, const OutputFolder& folder) {
  const modes::global::MapSettings& settings = the_case.global_modes.map;
  const lsa::Axis axis = axis_of(parameter(settings));
  const auto x = map["x"].get<std::vector<double>>(), mu = map["mu"].get<std::vector<double>>();
  CsvText table("growth rate and angular frequency in V/L of the global mode that grows most",
                {name(axis), "mu", "growth", "omega"});
  std::vector<double> growth, omega, neutral_x, neutral_y;
  for (std::size_t m = 0; m < mu.size(); ++m)
    for (std::size_t i = 0; i < x.size(); ++i) {
      growth.push_back(number_or_nan(map["growth"][m][i]));
      omega.push_back(number_or_nan(map["omega"][m][i]));
      table.row({x[i], mu[m], growth.back(), omega.back()});
    }
  write_file(folder / "global_map.csv", table.text());
  for (std::size_t i = 0; i < x.size(); ++i) {
    const Json& neutral = map["neutral"][i];
    const double lowest = neutral.empty() ? none : neutral[0].get<double>();
    neutral_x.push_back(x[i]);
    neutral_y.push_back(lowest <= mu.back() ? lowest : none);
  }
  const std::filesystem::path path = folder / "global_map.h5";
  {
    hdf5::Writer file(path);
    file.attributes({{"kind", "global_map"}, {"title", settings.title}, {"picture", "growth"}});
    file.write("/x", {x.size()}, x, attributes(axis, sweep(settings).scale));
    file.write("/y", {mu.size()}, mu, attributes(lsa::Axis::mu, settings.mu->scale));
    file.write("/fields/growth", {mu.size(), x.size()}, growth,
               {{"name", "growth"},
                {"meaning", "growth rate of the global mode that grows most, in V/L"},
                {"label", "growth rate {/:Italic σL}/{/:Italic V}"},
                {"is_signed", std::int64_t{0}}});
    file.write("/fields/omega", {mu.size(), x.size()}, omega,
               {{"name", "omega"},
                {"meaning", "its angular frequency, in V/L"},
                {"label", "{/:Italic ωL}/{/:Italic V}"},
                {"is_signed", std::int64_t{0}}});
    file.write("/neutral/x", {x.size()}, neutral_x, {{"label", "neutral curve"}});
    file.write("/neutral/y", {x.size()}, neutral_y);
    write_marks(the_case, parameter(settings), file);
    file.finish();
  }
  analysis::plot(path);
}

Json summary_of_map(const Json& map) {
  Json summary = {{"points", map["x"].size() * map["mu"].size()}};
  for (const char* key : {"basis_size", "fit_error", "basis_error", "checked_basis", "lambda_error",
                          "checked", "samples", "samples_off_axis", "sample_s", "map_s"})
    summary[key] = map[key];
  return summary;
}

std::string text_of_growth_map(const Json& map, double lambda_tolerance) {
  const double lambda_error = map["lambda_error"];
  std::string text = fmt::format(
      "  growth map: {} points in {:.3g} s after {} samples of the response in {:.3g} s, in a "
      "basis "
      "of {} shapes\n"
      "  error of lambda: {:.1e} at {} points by the response itself, {:.1e} at {} points by the "
      "whole flag\n",
      map["x"].size() * map["mu"].size(), map["map_s"].get<double>(),
      map["samples"].get<std::size_t>(), map["sample_s"].get<double>(),
      map["basis_size"].get<int>(), lambda_error, map["checked"].get<std::size_t>(),
      map["basis_error"].get<double>(), map["checked_basis"].get<std::size_t>());
  if (lambda_error > lambda_tolerance)
    text += fmt::format(
        "  which is more than modes.global.map.lambda_tolerance = {:.1e}; a smaller fit_tolerance, "
        "or fewer mass ratios at which the modes decay fast, may help\n",
        lambda_tolerance);
  return text;
}

std::string text_of_neutral_curve(const Json& global) {
  const std::string over = global["neutral_over"];
  std::string text =
      fmt::format("  neutral curve\n {:>11}       mu_cr       omega  branch\n", over);
  std::optional<int> branch;
  for (const Json& point : global["neutral"]) {
    const int here = point["branch"];
    text += fmt::format(" {:11.6g} {:11.6g} {:11.6g}  {:6}{}\n", point[over].get<double>(),
                        point["mu_cr"].get<double>(), point["omega"].get<double>(), here + 1,
                        branch.value_or(here) != here ? "  another mode is the first to grow" : "");
    branch = here;
    if (!point["largest_growth"].is_null())
      text += fmt::format(
          "             the full operator at mu_cr: largest growth rate {:.1e}, an eigenvalue "
          "{:.1e} from i omega\n",
          point["largest_growth"].get<double>(), point["distance"].get<double>());
  }
  for (const Json& missing : global["neutral_missing"])
    text += fmt::format("  left out: {} = {:.6g}: {}\n", over, missing[over].get<double>(),
                        missing["fault"].get<std::string>());
  return text;
}

}  // namespace pennon::app

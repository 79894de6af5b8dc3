#include "modes/global/study/neutral_report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"

namespace pennon::modes::global {
namespace {

using Json = nlohmann::ordered_json;

constexpr double none = std::numeric_limits<double>::quiet_NaN();

// None where the modes were followed, for then there was no fit.
std::optional<double> fit_error(const CurvePoint& point) {
  if (point.fit_error > 0) return point.fit_error;
  return std::nullopt;
}

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json();
}

Json to_json(const BranchPoint& at) {
  return {{"branch", at.branch},
          {"mu", at.mode.mu},
          {"omega", at.mode.omega},
          {"growth_by_mu", at.mode.by_mu.real()},
          {"residual", at.residual}};
}

Json to_json(const CurvePoint& point, CurveParameter parameter) {
  const BranchPoint& critical = point.modes.front();
  Json json = {{name(parameter), point.value},
               {"mu_cr", critical.mode.mu},
               {"omega", critical.mode.omega},
               {"branch", critical.branch},
               {"residual", critical.residual},
               {"fit_error", or_null(fit_error(point))},
               {"largest_growth", or_null(point.largest_growth)},
               {"distance", or_null(point.distance)},
               {"evaluations", point.evaluations},
               {"wall_s", point.seconds}};
  for (const BranchPoint& at : point.modes) json["modes"].push_back(to_json(at));
  return json;
}

// mu of each branch at each point, NaN where it was not found.
void write_branches(const std::vector<CurvePoint>& points, hdf5::Writer& file) {
  std::map<int, std::vector<double>> mu;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (const BranchPoint& at : points[i].modes) {
      std::vector<double>& row = mu[at.branch];
      row.resize(points.size(), none);
      row[i] = at.mode.mu;
    }
  std::vector<double> values;
  for (const auto& [branch, row] : mu) values.insert(values.end(), row.begin(), row.end());
  file.write("/branches", {mu.size(), points.size()}, values,
             {{"meaning", "mass ratio of each neutral mode that was followed"}});
}

}  // namespace

Json to_json(const NeutralCurve& curve) {
  Json points = Json::array(), missing = Json::array();
  for (const CurvePoint& point : curve.points) points.push_back(to_json(point, curve.parameter));
  for (const MissingPoint& point : curve.missing)
    missing.push_back({{name(curve.parameter), point.value}, {"fault", point.fault}});
  return {
      {"neutral", points}, {"neutral_over", name(curve.parameter)}, {"neutral_missing", missing}};
}

void write_tables(const NeutralCurve& curve, const OutputFolder& folder) {
  const std::string over = name(curve.parameter);
  CsvText critical(
      "critical mass ratio of the global modes; branch: which mode; residual: of the full "
      "operator; "
      "fit_error: of the response where all modes were sought; largest_growth, distance: of the "
      "full operator's leading modes at mu_cr",
      {over, "mu_cr", "omega", "branch", "residual", "fit_error", "largest_growth", "distance",
       "evaluations", "wall_s"});
  CsvText branches(
      "neutral global modes; growth_by_mu: what a little more mu adds to the growth rate",
      {over, "branch", "mu", "omega", "growth_by_mu", "residual"});
  for (const CurvePoint& point : curve.points) {
    const BranchPoint& first = point.modes.front();
    critical.row({point.value, first.mode.mu, first.mode.omega, static_cast<double>(first.branch),
                  first.residual, fit_error(point).value_or(none),
                  point.largest_growth.value_or(none), point.distance.value_or(none),
                  static_cast<double>(point.evaluations), point.seconds});
    for (const BranchPoint& at : point.modes)
      branches.row({point.value, static_cast<double>(at.branch), at.mode.mu, at.mode.omega,
                    at.mode.by_mu.real(), at.residual});
  }
  write_file(folder / "global_neutral.csv", critical.text());
  write_file(folder / "global_neutral_branches.csv", branches.text());
}

std::string text_of(const NeutralCurve& curve) {
  const std::string over = name(curve.parameter);
  std::string text =
      fmt::format("  neutral curve\n {:>11}       mu_cr       omega  branch\n", over);
  std::optional<int> branch;
  for (const CurvePoint& point : curve.points) {
    const BranchPoint& first = point.modes.front();
    text += fmt::format(
        " {:11.6g} {:11.6g} {:11.6g}  {:6}{}\n", point.value, first.mode.mu, first.mode.omega,
        first.branch + 1,
        branch.value_or(first.branch) != first.branch ? "  another mode is the first to grow" : "");
    branch = first.branch;
    if (point.largest_growth)
      text += fmt::format(
          "             the full operator at mu_cr: largest growth rate {:.1e}, an eigenvalue "
          "{:.1e} from i omega\n",
          *point.largest_growth, point.distance.value_or(none));
  }
  for (const MissingPoint& point : curve.missing)
    text += fmt::format("  left out: {} = {:.6g}: {}\n", over, point.value, point.fault);
  return text;
}

void write_hdf5(const NeutralCurve& curve, const NeutralPicture& picture,
                const std::filesystem::path& path) {
  std::vector<double> x, mu;
  for (const CurvePoint& point : curve.points) {
    x.push_back(point.value);
    mu.push_back(point.modes.front().mode.mu);
  }
  hdf5::Writer file(path);
  file.attributes({{"kind", "global_neutral"}, {"title", picture.title}});
  file.write("/x", {x.size()}, x, picture.axis);
  file.write(
      "/mu_cr", {mu.size()}, mu,
      {{"meaning", "critical mass ratio of the global modes"}, {"label", "{/:Italic μ}_{cr}"}});
  write_branches(curve.points, file);
  for (const OtherCurve& other : picture.local_theory) {
    file.write("/local/" + other.name + "/x", {other.x.size()}, other.x);
    file.write("/local/" + other.name + "/y", {other.mu_cr.size()}, other.mu_cr);
  }
  write(picture.outcomes, file);
  file.finish();
}

}  // namespace pennon::modes::global

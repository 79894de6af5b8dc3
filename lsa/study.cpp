#include "lsa/study.hpp"

#include <algorithm>
#include <cmath>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::lsa {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

// The critical mass ratio over the searched k_y, a curve for each span in the table.
Curve critical_mass_ratios(const Settings& settings, const Point& point,
                           const std::vector<Outcome>& outcomes) {
  CurveSettings curve;
  curve.is_given = true;
  curve.sweeps[static_cast<std::size_t>(Axis::k_y)] = settings.verdicts.k_y;
  Sweep spans;
  for (const Outcome& outcome : outcomes)
    if (std::ranges::find(spans.list, outcome.k_x()) == spans.list.end())
      spans.list.push_back(outcome.k_x());
  std::ranges::sort(spans.list);
  curve.sweeps[static_cast<std::size_t>(Axis::k_x)] = spans;
  return compute(curve, point, settings.theory);
}

void write_verdicts(const Verdicts& verdicts, const Curve& curve, const OutputFolder& folder) {
  CsvText table("verdicts of the local theory beside the table's; mu_cr empty where there is none",
                {"case", "table", "theory", "mu", "k_x", "P", "growth", "mu_cr"});
  std::vector<double> mu;
  for (const auto& [outcome, stability] : verdicts.rows) {
    table.row({outcome.mu, outcome.k_x(), stability.P, stability.growth, stability.mu_cr},
              {outcome.name, outcome.is_unstable ? "U" : "S", stability.is_unstable() ? "U" : "S"});
    if (std::ranges::find(mu, outcome.mu) == mu.end()) mu.push_back(outcome.mu);
  }
  write_file(folder / "verdicts.csv", table.text());

  hdf5::Writer file(folder / "verdicts.h5");
  file.attributes({{"kind", "lsa_verdicts"}, {"title", ""}});
  write_lines(curve, file);
  file.write("/mu", {mu.size()}, mu, {{"meaning", "the mass ratios of the table"}});
  std::vector<double> ends;
  for (const auto& [low, high] : verdicts.reproduced) ends.insert(ends.end(), {low, high});
  if (!ends.empty())
    file.write("/reproduced", {ends.size() / 2, 2}, ends,
               {{"meaning", "intervals of k_y over which every verdict is reproduced"}});
  file.finish();
}

Json to_json(const Stability& stability) {
  return {{"c_m", stability.c_m},
          {"P", number_or_null(stability.P)},
          {"omega",
           {{stability.omega_r_plus, stability.omega_i_plus},
            {stability.omega_r_minus, stability.omega_i_minus}}},
          {"growth", stability.growth},
          {"frequency", stability.frequency},
          {"mu_cr", number_or_null(stability.mu_cr)},
          {"unstable", stability.is_unstable()}};
}

Json to_json(const Verdicts& verdicts) {
  Json json;
  json["agreeing"] = std::ranges::count_if(verdicts.rows, &Verdict::agrees);
  json["rows"] = verdicts.rows.size();
  json["most_agreeing"] = verdicts.most_agreeing;
  json["reproduced_for_k_y"] = verdicts.reproduced;
  for (const Verdict& row : verdicts.rows)
    json["cases"].push_back({{"case", row.outcome.name},
                             {"mu_cr", number_or_null(row.stability.mu_cr)},
                             {"unstable", row.stability.is_unstable()},
                             {"agrees", row.agrees()}});
  return json;
}

}  // namespace

Result run(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
           const OutputFolder& folder, bool shows_progress) {
  const Point point = point_of(flag, flow, settings);
  const Theory& theory = settings.theory;
  std::vector<Outcome> marks;
  if (settings.marks.is_given) marks = read_outcomes(settings.marks.table);
  std::vector<Outcome> outcomes;
  if (settings.verdicts.is_given) outcomes = read_outcomes(settings.verdicts.table);

  Result result{point, solve(point, theory), {}, {}, {}, {}, {}};
  if (settings.curve.is_given) {
    result.curve = compute(settings.curve, point, theory);
    write_csv(*result.curve, folder / "curve.csv");
    write_hdf5(*result.curve, marks, theory.model.cross_flow, folder / "curve.h5");
  }
  if (settings.map.is_given)
    result.map = compute_map(settings.map, point, theory, marks, folder, shows_progress);
  if (const MostUnstableSettings& sought = settings.most_unstable; sought.is_given) {
    result.sought = sought.k_x ? Axis::k_x : Axis::k_y;
    result.most_unstable =
        most_unstable(point, theory, *result.sought, sought.k_x ? *sought.k_x : *sought.k_y);
  }
  if (settings.verdicts.is_given) {
    result.verdicts = compare(outcomes, point, theory, *settings.verdicts.k_y);
    write_verdicts(*result.verdicts, critical_mass_ratios(settings, point, outcomes), folder);
  }
  return result;
}

Json to_json(const Result& result) {
  Json json = {{"k_x", result.point.k_x}, {"k_y", result.point.k_y}};
  json.update(to_json(result.stability));
  if (result.curve)
    json["curve"] = {{"quantity", result.curve->quantity},
                     {"points", result.curve->x.size()},
                     {"curves", result.curve->family.size()}};
  if (result.map)
    json["map"] = {{"points", result.map->points},
                   {"unstable", result.map->unstable},
                   {"neutral_pieces", result.map->neutral.size()},
                   {"wall_s", result.map->wall_seconds}};
  if (result.sought) {
    Json& found = json["most_unstable"];
    if (result.most_unstable) {
      found[name(*result.sought)] = result.most_unstable->wavenumber;
      found.update(to_json(result.most_unstable->stability));
      found["is_at_an_end"] = result.most_unstable->is_at_an_end;
    }
  }
  if (result.verdicts) json["verdicts"] = to_json(*result.verdicts);
  return json;
}

}  // namespace pennon::lsa

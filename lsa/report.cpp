#include "lsa/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <vector>

#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::lsa {
namespace {

using Json = nlohmann::ordered_json;

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

void write_verdicts(const Verdicts& verdicts, const Curve& critical_mass_ratios,
                    const OutputFolder& folder) {
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
  write_lines(critical_mass_ratios, file);
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

std::string text_of_point(const Result& result) {
  const Stability& s = result.stability;
  std::string text = fmt::format(
      "  mu = {:.4g}, Re = {:.4g}, k_x = {:.4g}, k_y = {:.4g}: c_m = {:.4g}, P = {:.4g}\n",
      result.point.mu, result.point.Re, result.point.k_x, result.point.k_y, s.c_m, s.P);
  text += s.is_unstable() ? fmt::format("  unstable: growth rate {:.4g} V/L, frequency {:.4g} V/L",
                                        s.growth, s.frequency)
                          : fmt::format("  stable: angular frequencies {:.4g} and {:.4g} V/L",
                                        s.omega_r_plus, s.omega_r_minus);
  text += std::isnan(s.mu_cr) ? "; no mass ratio is unstable\n"
                              : fmt::format("; critical mass ratio {:.4g}\n", s.mu_cr);
  return text;
}

std::string text_of_verdicts(const Verdicts& verdicts) {
  std::string text = "  case      table  theory  mu      mu_cr\n";
  std::size_t agreeing = 0;
  for (const Verdict& row : verdicts.rows) {
    text +=
        fmt::format("  {:<9} {:<6} {:<7} {:<7.4g} {:.4g}{}\n", row.outcome.name,
                    row.outcome.is_unstable ? "U" : "S", row.stability.is_unstable() ? "U" : "S",
                    row.outcome.mu, row.stability.mu_cr, row.agrees() ? "" : "  differs");
    agreeing += row.agrees() ? 1 : 0;
  }
  text += fmt::format("  {} of {} verdicts reproduced", agreeing, verdicts.rows.size());
  for (const auto& [low, high] : verdicts.reproduced)
    text += fmt::format("; all of them for {:.6g} <= k_y <= {:.6g}", low, high);
  if (verdicts.reproduced.empty())
    text += fmt::format("; at best {} over the searched k_y", verdicts.most_agreeing);
  return text + "\n";
}

}  // namespace

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

void write_tables(const Result& result, const OutputFolder& folder) {
  if (result.curve) {
    write_csv(*result.curve, folder / "curve.csv");
    write_hdf5(*result.curve, result.marks, result.has_cross_flow, folder / "curve.h5");
  }
  if (result.verdicts) write_verdicts(*result.verdicts, *result.critical_mass_ratios, folder);
}

std::string text_of(const Result& result) {
  std::string text = text_of_point(result);
  if (result.map)
    text += fmt::format(
        "  map: {} points in {:.3g} s, {:.3g} % unstable, neutral curve in {} piece{}\n",
        result.map->points, result.map->wall_seconds,
        100.0 * static_cast<double>(result.map->unstable) / static_cast<double>(result.map->points),
        result.map->neutral.size(), result.map->neutral.size() == 1 ? "" : "s");
  if (result.sought && result.most_unstable)
    text +=
        fmt::format("  most unstable {} = {:.6g}: growth rate {:.4g} V/L{}\n", name(*result.sought),
                    result.most_unstable->wavenumber, result.most_unstable->stability.growth,
                    result.most_unstable->is_at_an_end ? ", at an end of the searched range" : "");
  else if (result.sought)
    text += fmt::format("  no searched {} is unstable\n", name(*result.sought));
  if (result.verdicts) text += text_of_verdicts(*result.verdicts);
  return text;
}

}  // namespace pennon::lsa

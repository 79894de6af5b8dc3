#include <fmt/format.h>

#include "analysis/figures/plot.hpp"
#include "app/commands.hpp"
#include "lsa/study.hpp"

namespace pennon::app {
namespace {

std::string text_of_point(const lsa::Result& result) {
  const lsa::Stability& s = result.stability;
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

std::string text_of_verdicts(const lsa::Verdicts& verdicts) {
  std::string text = "  case      table  theory  mu      mu_cr\n";
  std::size_t agreeing = 0;
  for (const lsa::Verdict& row : verdicts.rows) {
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

std::string text_of(const lsa::Result& result) {
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

}  // namespace

void run_lsa(const Options& options) {
  const auto work = [&](const Case& the_case, const OutputFolder& folder, Record& record) {
    const lsa::Result result = [&] {
      const auto timer = record.time("lsa");
      return lsa::run(the_case.lsa, the_case.flag, the_case.flow, folder, !options.quiet);
    }();
    const auto timer = record.time("pictures");
    if (result.curve) analysis::plot(folder / "curve.h5");
    if (result.map) analysis::plot(folder / "map.h5");
    if (result.verdicts) analysis::plot(folder / "verdicts.h5");
    return Answer{{{"lsa", to_json(result)}},
                  fmt::format("{}: local stability\n{}", the_case.name, text_of(result))};
  };
  run({{.flow = true, .lsa = true}, {}, work}, options);
}

}  // namespace pennon::app

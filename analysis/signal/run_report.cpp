#include "analysis/signal/run_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "analysis/signal/series.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"

namespace pennon::analysis {
namespace {

using Json = nlohmann::ordered_json;

Json or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json limit_cycle_json(const RunAnalysis& found) {
  std::optional<double> A, f_s, St, C_D, C_L, f_v;
  if (const auto& cycle = found.limit_cycle.cycle) {
    A = cycle->A_over_L;
    f_s = cycle->f_s;
    f_v = cycle->f_v;
    St = cycle->St;
    C_D = cycle->C_D_mean;
    C_L = cycle->C_L_amp;
  }
  return {{"A_over_L", or_null(A)},
          {"f_s", or_null(f_s)},
          {"f_v", or_null(f_v)},
          {"St", or_null(St)},
          {"C_D_mean", or_null(C_D)},
          {"C_L_amp", or_null(C_L)},
          {"theta_s_deg", or_null(found.angles.theta_s_deg)},
          {"theta_v_deg", or_null(found.angles.theta_v_deg)}};
}

Json growth_json(const LinearPhase& linear) {
  if (!linear.growth) {
    Json json;
    for (const char* key : {"sigma", "omega", "sigma_error", "omega_error", "from", "to", "wave"})
      json[key] = nullptr;
    return json;
  }
  const Growth& growth = *linear.growth;
  return {{"sigma", growth.sigma},
          {"omega", growth.omega},
          {"sigma_error", growth.sigma_error},
          {"omega_error", growth.omega_error},
          {"from", growth.from},
          {"to", growth.to},
          {"wave", linear.wave}};
}

std::string number_or(const std::optional<double>& value) {
  return value ? fmt::format("{:.4g}", *value) : std::string("-");
}

void write_amplitudes(const RunAnalysis& found, const OutputFolder& folder) {
  const std::vector<std::vector<double>> sizes = moduli(found.components);
  std::vector<std::string> columns = {"t", "z_antinode"};
  for (std::size_t n = 0; n < sizes.size(); ++n) columns.push_back(fmt::format("zeta_{}", n));
  CsvText table("trailing edge: z at the antinode and |zeta_n| along the span, in L; t in L/V",
                columns);
  const std::vector<double>& z = found.run.z[antinode_of(found.run)];
  for (std::size_t row = 0; row < found.run.t.size(); ++row) {
    std::vector<double> values = {found.run.t[row], z[row]};
    for (const std::vector<double>& size : sizes) values.push_back(size[row]);
    table.row(values);
  }
  write_file(folder / "spanwise_amplitudes.csv", table.text());
}

void write_limit_cycle(const RunAnalysis& found, const OutputFolder& folder) {
  CsvText table(
      "the last periods of the trailing edge at its antinode: begin and length in L/V, amplitude "
      "in "
      "L; mean of C_D, half range of C_L",
      {"begin", "length", "amplitude", "C_D_mean", "C_L_amp"});
  if (const auto& cycle = found.limit_cycle.cycle) {
    const Spline C_D(found.run.t, found.run.column("C_D"));
    for (const Period& period : cycle->periods) {
      const double end = period.begin + period.length;
      table.row(
          {period.begin, period.length, period.amplitude,
           C_D.integral(period.begin, end) / period.length,
           half_range(found.run.column("C_L"), rows_between(found.run.t, period.begin, end))});
    }
  }
  write_file(folder / "limit_cycle.csv", table.text());
}

void write_energy(const RunAnalysis& found, const OutputFolder& folder) {
  const EnergyBudget& e = found.energy;
  CsvText table(
      "energies per span in rho_f V^2 L^2, t in L/V; defect: total - received + lost, less its "
      "first "
      "value; exchange: its part between flag and fluid; E_t, defect_t: changes in the convective "
      "period before, of total - received relative to itself (Table 2), of the defect relative to "
      "the total",
      {"t", "fluid", "flag_kinetic", "bending", "stretch", "gravity", "flag", "total", "received",
       "lost", "defect", "exchange", "E_t", "defect_t"});
  const std::vector<double> E_t = change_in_convective_period(e.t, e.balance, e.balance);
  const std::vector<double> defect_t = change_in_convective_period(e.t, e.defect, e.total);
  for (std::size_t row = 0; row < e.t.size(); ++row)
    table.row({e.t[row], e.fluid[row], e.flag_kinetic[row], e.bending[row], e.stretch[row],
               e.gravity[row], e.flag[row], e.total[row], e.received[row], e.lost[row],
               e.defect[row], e.exchange[row], E_t[row], defect_t[row]});
  write_file(folder / "energy.csv", table.text());
}

}  // namespace

nlohmann::ordered_json to_json(const RunAnalysis& found) {
  return {{"limit_cycle", limit_cycle_json(found)},
          {"growth", growth_json(found.linear)},
          {"phases",
           {{"I_end", or_null(found.phases.I_end)}, {"II_end", or_null(found.phases.II_end)}}},
          {"energy",
           {{"residual", found.energy.residual},
            {"exchange", found.energy.residual_exchange},
            {"residual_per_time", found.energy.residual_per_time}}},
          {"notes", found.notes()}};
}

std::string text_of(const RunAnalysis& found) {
  std::string text;
  if (const auto& g = found.linear.growth)
    text += fmt::format(
        "  growth: sigma = {:.4g} +- {:.1g}, omega = {:.4g} +- {:.1g}, in component {} from t = "
        "{:.4g} to {:.4g}\n",
        g->sigma, g->sigma_error, g->omega, g->omega_error, found.linear.wave, g->from, g->to);
  if (const auto& cycle = found.limit_cycle.cycle)
    text += fmt::format(
        "  limit cycle over {} periods: A/L = {:.4g}, f_s = {:.4g}, f_v = {}, St = {:.4g}, C_D = "
        "{:.4g}, amplitude of C_L {:.4g}, theta_s = {}, theta_v = {} degrees\n",
        cycle->periods.size(), cycle->A_over_L, cycle->f_s, number_or(cycle->f_v), cycle->St,
        cycle->C_D_mean, cycle->C_L_amp, number_or(found.angles.theta_s_deg),
        number_or(found.angles.theta_v_deg));
  text += fmt::format("  phase I ends at t = {}, phase II at {}; component {} rules at the end\n",
                      number_or(found.phases.I_end), number_or(found.phases.II_end),
                      found.phases.ruling);
  return text + fmt::format(
                    "  energy: defect at most {:.2g} of the largest kinetic energy, of that {:.2g} "
                    "between flag and fluid; in one L/V at most {:.2g} of the energy\n",
                    found.energy.residual, found.energy.residual_exchange,
                    found.energy.residual_per_time);
}

void write_tables(const RunAnalysis& found, const OutputFolder& folder) {
  write_amplitudes(found, folder);
  write_limit_cycle(found, folder);
  write_energy(found, folder);
}

}  // namespace pennon::analysis

// The coupled flag by the commands a user has: growth rates, limit cycles, robustness, and what
// they owe to grid, step and domain. Kept under data/reference/pennon.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "common/io/csv.hpp"
#include "tests/support/commands.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using test::expect_reference;
using Settings = std::vector<std::string>;

class Coupled : public test::Commands {
 protected:
  // A command on a case with --set for each of `settings`; what it says.
  test::Outcome run(const std::string& command, const std::string& the_case,
                    const Settings& settings) {
    std::vector<std::string> arguments = {
        command,    (test::source / "data/cases" / the_case).string(),
        "--json",   "--quiet",
        "--output", results()};
    for (const std::string& setting : settings)
      arguments.insert(arguments.end(), {"--set", setting});
    return pennon(arguments);
  }
  test::Outcome simulate(const std::string& the_case, const Settings& settings) {
    return run("dns", the_case, settings);
  }
  // The local theory's verdict.
  bool is_unstable_locally(const std::string& the_case, const Settings& settings) {
    const test::Outcome outcome = run("lsa", the_case, settings);
    EXPECT_EQ(outcome.status, test::done) << outcome.err;
    return json::parse(outcome.out).at("lsa").at("unstable").get<bool>();
  }
  json analyze(const Settings& options = {}) {
    std::vector<std::string> arguments = {"analyze", results(), "--json", "--quiet"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const test::Outcome outcome = pennon(arguments);
    EXPECT_EQ(outcome.status, test::done) << outcome.err;
    return json::parse(outcome.out).at("analyze");
  }
  // Of the trailing edge, after analyze(): at its antinode, or of a wave.
  double largest_swing(double from, double to, const std::string& column = "z_antinode") {
    const CsvTable edge(std::filesystem::path(results()) /
                        "analysis/signal/spanwise_amplitudes.csv");
    const std::vector<double> t = edge.numbers("t"), values = edge.numbers(column);
    double largest = 0;
    for (std::size_t row = 0; row < t.size(); ++row)
      if (t[row] >= from && t[row] <= to) largest = std::max(largest, std::abs(values[row]));
    return largest;
  }
  static double number(const json& value) { return value.is_number() ? value.get<double>() : NAN; }
};

struct Discretisation {
  int n_rho;
  double dt, R;
};
constexpr Discretisation usual{60, 0.002, 8};
constexpr Discretisation others[] = {
    {40, 0.002, 8}, {90, 0.002, 8}, {60, 0.004, 8}, {60, 0.001, 8}, {60, 0.002, 16}};

Settings settings_of(const Discretisation& d) {
  return {fmt::format("dns.n_rho={}", d.n_rho), fmt::format("dns.n_theta={}", 2 * d.n_rho),
          fmt::format("dns.wall_spacing={}", 0.72 / d.n_rho), fmt::format("dns.dt={}", d.dt),
          fmt::format("dns.R={:.1f}", d.R)};
}

std::vector<Discretisation> all_discretisations() {
  std::vector<Discretisation> all = {usual};
  all.insert(all.end(), std::begin(others), std::end(others));
  return all;
}

// Small motions in two dimensions: the global eigenmodes must give these numbers.
TEST_F(Coupled, SmallMotionsGrowAndDecayByOneMode) {
  struct Flag {
    double mu;
    Settings start;    // beside the case's
    Settings options;  // of the analysis
  };
  // What decays starts larger, without a kick, and is looked at from a time when one mode is left.
  const std::vector<Flag> flags = {
      {0.025,
       {"dns.initial.A=[0.01]", "dns.initial.kick=0.0", "dns.initial.release=0.0"},
       {"--from", "3", "--to", "8"}},
      {0.075, {"dns.t_end=12.0"}, {}},
      {0.125, {"dns.t_end=11.0"}, {}},
      {0.25, {"dns.initial.kick=1e-6", "dns.t_end=11.0"}, {}}};
  std::vector<std::vector<double>> rows;
  for (const Flag& flag : flags)
    for (const Discretisation& d : all_discretisations()) {
      Settings settings = settings_of(d);
      settings.push_back(fmt::format("flag.mu={}", flag.mu));
      settings.insert(settings.end(), flag.start.begin(), flag.start.end());
      const test::Outcome outcome = simulate("coupled/growth.toml", settings);
      ASSERT_EQ(outcome.status, test::done) << outcome.err;
      const json growth = analyze(flag.options).at("growth");
      rows.push_back({flag.mu, static_cast<double>(d.n_rho), d.dt, d.R, number(growth.at("sigma")),
                      number(growth.at("sigma_error")), number(growth.at("omega")),
                      number(growth.at("omega_error"))});
      EXPECT_EQ(rows.back()[4] > 0, flag.mu > 0.05);
    }
  expect_reference(
      "coupled_growth.csv",
      "growth rate and angular frequency of small motions, Re = 1000, K_B = 1e-4, two "
      "dimensions; data/cases/coupled/growth.toml, tests/validation/dns/coupling/coupled_cases.cpp",
      {"mu", "n_rho", "dt", "R", "sigma", "sigma_error", "omega", "omega_error"}, rows, 0.02);
}

// C2D: what its limit cycle owes to everything that should not matter.
TEST_F(Coupled, TheLimitCycleOfC2DIsConverged) {
  struct Variant {
    Discretisation discretisation;
    double K_S, damping;
  };
  std::vector<Variant> variants;
  for (const Discretisation& d : all_discretisations()) variants.push_back({d, 500, 0.02});
  variants.insert(variants.end(), {{usual, 5, 0.02},
                                   {usual, 250, 0.02},
                                   {usual, 1000, 0.02},
                                   {usual, 500, 0.005},
                                   {usual, 500, 0.05}});
  std::vector<std::vector<double>> rows;
  for (const Variant& variant : variants) {
    Settings settings = settings_of(variant.discretisation);
    settings.insert(settings.end(), {fmt::format("flag.K_S={:.1f}", variant.K_S),
                                     fmt::format("flag.damping={}", variant.damping)});
    const test::Outcome outcome = simulate("table1/C2D.toml", settings);
    ASSERT_EQ(outcome.status, test::done) << outcome.err;
    const json dns = json::parse(outcome.out).at("dns"), cycle = analyze().at("limit_cycle");
    rows.push_back({static_cast<double>(variant.discretisation.n_rho), variant.discretisation.dt,
                    variant.discretisation.R, variant.K_S, variant.damping,
                    number(cycle.at("A_over_L")), number(cycle.at("f_s")), number(cycle.at("f_v")),
                    number(cycle.at("C_D_mean")), number(cycle.at("C_L_amp")),
                    number(dns.at("coupling_iterations").at("mean"))});
    EXPECT_NEAR(rows.back()[5], 0.14, 0.02);
    EXPECT_LT(rows.back()[10], 5);
  }
  for (std::size_t k = 1; k < rows.size(); ++k)
    for (std::size_t value : {5UL, 6UL}) EXPECT_NEAR(rows[k][value] / rows[0][value], 1, 0.05);
  expect_reference("coupled_limit_cycle_C2D.csv",
                   "limit cycle of case C2D of Table 1 at t = 40; data/cases/table1/C2D.toml, "
                   "tests/validation/dns/coupling/coupled_cases.cpp",
                   {"n_rho", "dt", "R", "K_S", "damping", "A_over_L", "f_s", "f_v", "C_D_mean",
                    "C_L_amp", "passes_mean"},
                   rows, 0.01);
}

TEST_F(Coupled, AHangingFlagFlaps) {
  std::vector<std::vector<double>> rows;
  for (const double K_B : {0.00225, 0.0015})
    for (const Discretisation& d :
         {usual, Discretisation{40, 0.002, 8}, Discretisation{60, 0.004, 8}}) {
      Settings settings = settings_of(d);
      settings.insert(settings.end(), {fmt::format("flag.K_B={}", K_B), "dns.t_end=60.0"});
      const test::Outcome outcome = simulate("coupled/gravity.toml", settings);
      ASSERT_EQ(outcome.status, test::done) << outcome.err;
      const json cycle = analyze().at("limit_cycle");
      rows.push_back({K_B, static_cast<double>(d.n_rho), d.dt, number(cycle.at("A_over_L")),
                      number(cycle.at("f_s")), number(cycle.at("C_D_mean")),
                      number(cycle.at("C_L_amp"))});
      EXPECT_GT(rows.back()[3], 0.1);
    }
  expect_reference(
      "coupled_gravity.csv",
      "limit cycle of a hanging flag, Re = 200, mu = 1.5, gravity 0.5; "
      "data/cases/coupled/gravity.toml, tests/validation/dns/coupling/coupled_cases.cpp",
      {"K_B", "n_rho", "dt", "A_over_L", "f_s", "C_D_mean", "C_L_amp"}, rows, 0.01);
}

// What the method loses of the energy of flag and fluid, three convective periods after a smooth
// start: of second order once the wake's vortices are resolved.
TEST_F(Coupled, EnergyIsKeptToSecondOrder) {
  std::vector<std::vector<double>> rows;
  for (const int n_rho : {40, 60, 90, 135, 200}) {
    Settings settings = settings_of({n_rho, 0.12 / n_rho, 8});
    settings.insert(settings.end(), {"dns.t_end=3.0", "dns.initial.A=[0.1]", "dns.initial.ramp=1.0",
                                     "dns.output.shape_interval=0.0"});
    const test::Outcome outcome = simulate("table1/C2D.toml", settings);
    ASSERT_EQ(outcome.status, test::done) << outcome.err;
    analyze();
    const CsvTable energy(std::filesystem::path(results()) / "analysis/energy.csv");
    const auto last = [&](const std::string& column) { return energy.numbers(column).back(); };
    rows.push_back({static_cast<double>(n_rho), 0.12 / n_rho, last("total"), last("defect"),
                    last("exchange")});
    if (rows.size() == 1) continue;
    const std::vector<double>& coarser = rows[rows.size() - 2];
    rows.back().push_back(std::log(coarser[3] / rows.back()[3]) / std::log(n_rho / coarser[0]));
    EXPECT_GT(rows.back()[5], rows.size() == 2 ? 1.0 : coarser[5]);
    EXPECT_LT(std::abs(rows.back()[4]), 0.01 * std::abs(rows.back()[3]));
  }
  EXPECT_GT(rows.back()[5], 1.85);
  rows.front().push_back(0);
  expect_reference(
      "coupled_energy.csv",
      "budget of energy at t = 3 of case C2D with A = 0.1 and a stream that rises over "
      "one L/V; tests/validation/dns/coupling/coupled_cases.cpp",
      {"n_rho", "dt", "total", "defect", "exchange", "order"}, rows, 0.05);
}

// However light the flag, however long the step: passes, and whether the run comes to its end.
TEST_F(Coupled, StandsLightFlagsAndLongSteps) {
  std::vector<std::vector<double>> rows;
  for (const double mu : {1e-3, 1e-2, 0.025, 0.125, 1.0, 10.0})
    for (const double dt : {5e-4, 1e-3, 2e-3, 4e-3, 8e-3}) {
      const test::Outcome outcome =
          simulate("table1/C2D.toml", {fmt::format("flag.mu={}", mu), fmt::format("dns.dt={}", dt),
                                       "dns.t_end=1.5", "dns.output.shape_interval=0.0"});
      const bool is_done = outcome.status == test::done;
      const json dns = is_done ? json::parse(outcome.out).at("dns") : json();
      rows.push_back({mu, dt, is_done ? 1.0 : 0.0,
                      is_done ? number(dns.at("coupling_iterations").at("mean")) : 0,
                      is_done ? number(dns.at("coupling_iterations").at("max")) : 0,
                      is_done ? number(dns.at("pressure_iterations").at("mean")) : 0});
      EXPECT_TRUE(is_done) << "mu = " << mu << ", dt = " << dt << ": " << outcome.err;
    }
  expect_reference("coupled_robustness.csv",
                   "from C2D's start to t = 1.5 over mass ratio and step; "
                   "tests/validation/dns/coupling/coupled_cases.cpp",
                   {"mu", "dt", "is_done", "passes_mean", "passes_max", "pressure_iterations_mean"},
                   rows, 0.05);
}

// The fifteen marks of figure 5: does one small wave along the span grow?
TEST_F(Coupled, OneWaveAlongTheSpanGrowsOrDecaysAsFigure5Says) {
  std::vector<std::vector<double>> rows;
  for (const double mu : {0.025, 0.075, 0.125})
    for (const double gamma : {0.0, 5.0, 3.0, 2.0, 1.0}) {  // 0: two dimensions
      Settings settings = {fmt::format("flag.mu={}", mu)};
      if (gamma > 0) settings.push_back(fmt::format("flag.gamma={:.1f}", gamma));
      const bool lsa =
          is_unstable_locally(gamma > 0 ? "coupled/one_wave.toml" : "table1/C2D.toml", settings);
      const test::Outcome outcome =
          gamma > 0 ? simulate("coupled/one_wave.toml", settings)
                    : simulate("coupled/growth.toml",
                               {settings.front(), "dns.initial.kick=0.0", "dns.initial.release=0.0",
                                "dns.initial.A=[1e-5]", "dns.dt=0.004", "dns.t_end=12.0"});
      ASSERT_EQ(outcome.status, test::done) << outcome.err;
      const json growth = analyze().at("growth");
      rows.push_back({mu, gamma, number(growth.at("sigma")), number(growth.at("sigma_error")),
                      number(growth.at("omega")), largest_swing(11, 12) / largest_swing(0, 1),
                      lsa ? 1.0 : 0.0});
      EXPECT_EQ(rows.back()[5] > 1, lsa) << "mu = " << mu << ", gamma = " << gamma;
      EXPECT_TRUE(std::isnan(rows.back()[2]) || (rows.back()[2] > 0) == lsa);
    }
  expect_reference("coupled_figure5.csv",
                   "growth of one wave along the span, Re = 1000, K_B = 1e-4, gamma = 0: two "
                   "dimensions; no sigma where no single mode rules; ratio: largest swing of the "
                   "trailing edge from t = 11 to 12 over that to 1; lsa_unstable: the local "
                   "theory's verdict, with which the paper's agrees; "
                   "data/cases/coupled/one_wave.toml, "
                   "tests/validation/dns/coupling/coupled_cases.cpp",
                   {"mu", "gamma", "sigma", "sigma_error", "omega", "ratio", "lsa_unstable"}, rows,
                   0.02);
}

// An oblique wave stretches a span of fixed length: how stiff may it be?
TEST_F(Coupled, AnObliqueWaveNeedsASoftSpan) {
  std::vector<std::vector<double>> rows;
  for (const double K_S : {1.0, 2.0, 5.0, 20.0, 100.0, 500.0}) {
    const test::Outcome outcome =
        simulate("table1/C2U025.toml", {fmt::format("flag.K_S={:.1f}", K_S), "dns.n_x=12"});
    ASSERT_EQ(outcome.status, test::done) << outcome.err;
    const json cycle = analyze().at("limit_cycle");
    // Over the last L/V.
    const double wave = largest_swing(15, 16, "zeta_1"), straight = largest_swing(15, 16, "zeta_0");
    rows.push_back({K_S, straight, wave, number(cycle.at("A_over_L")), number(cycle.at("f_s")),
                    number(cycle.at("C_D_mean")), number(cycle.at("theta_s_deg"))});
    EXPECT_EQ(wave > straight, K_S < 10);
  }
  expect_reference("coupled_K_S_C2U025.csv",
                   "case C2U025 of Table 1 with 12 planes over the extensional stiffness; zeta_0, "
                   "zeta_1: the largest over the last L/V, to t = 16; limit cycle where there is "
                   "one; tests/validation/dns/coupling/coupled_cases.cpp",
                   {"K_S", "zeta_0", "zeta_1", "A_over_L", "f_s", "C_D_mean", "theta_s_deg"}, rows,
                   0.05);
}

}  // namespace
}  // namespace pennon

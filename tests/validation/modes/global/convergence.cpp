// What the leading global modes owe to the grid, the domain and the step, with Richardson's
// estimates of their limit. Kept under data/reference/pennon.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <nlohmann/json.hpp>

#include "tests/support/commands.hpp"
#include "tests/support/reference_table.hpp"

namespace pennon {
namespace {

using nlohmann::json;
using Complex = std::complex<double>;

struct ModeOfCase {
  double mu, gamma;  // gamma = 0: two dimensions
  Complex near;
};

constexpr std::array<ModeOfCase, 8> cases = {{{0.025, 0, {-0.497, 6.245}},
                                              {0.075, 0, {0.411, 5.545}},
                                              {0.125, 0, {0.974, 4.977}},
                                              {0.25, 0, {1.588, 3.866}},
                                              {0.075, 1, {-0.3, 5.8}},
                                              {0.125, 1, {0.063, 5.018}},
                                              {0.125, 2, {0.74, 4.85}},
                                              {0.125, 5, {0.942, 4.95}}}};

struct Numerics {
  int n_rho, n_theta;
  double R, wall_spacing, dt;
};

constexpr Numerics usual = {60, 120, 8, 0.012, 0.002};
constexpr std::array<Numerics, 4> grids = {{{40, 80, 8, 0.018, 0.002},
                                            usual,
                                            {90, 180, 8, 0.008, 0.002},
                                            {135, 270, 8, 0.016 / 3, 0.002}}};
// With as many rows as keep the grid near the flag what it is.
constexpr std::array<Numerics, 3> others = {
    {{72, 120, 16, 0.012, 0.002}, {84, 120, 32, 0.012, 0.002}, {60, 120, 8, 0.012, 0.0005}}};

class GlobalConvergence : public test::Commands {
 protected:
  Complex mode(const ModeOfCase& the_case, const Numerics& numerics) {
    std::vector<std::string> arguments = {
        "modes",    (test::source / "data/cases/modes/global.toml").string(),
        "--json",   "--quiet",
        "--output", results()};
    const auto set = [&](const std::string& key, const std::string& value) {
      arguments.insert(arguments.end(), {"--set", key + "=" + value});
    };
    set("flag.mu", fmt::format("{}", the_case.mu));
    if (the_case.gamma > 0) set("flag.gamma", fmt::format("{:.1f}", the_case.gamma));
    set("modes.global.n_modes", "1");
    set("modes.global.target",
        fmt::format("[{:.4f}, {:.4f}]", the_case.near.real(), the_case.near.imag()));
    set("dns.n_rho", std::to_string(numerics.n_rho));
    set("dns.n_theta", std::to_string(numerics.n_theta));
    set("dns.R", fmt::format("{:.1f}", numerics.R));
    set("dns.wall_spacing", fmt::format("{:.10f}", numerics.wall_spacing));
    set("dns.dt", fmt::format("{}", numerics.dt));
    const test::Outcome outcome = pennon(arguments);
    EXPECT_EQ(outcome.status, test::done) << outcome.err;
    const json found = json::parse(outcome.out).at("global").at("modes").at(0);
    return {found.at("growth").get<double>(), found.at("omega").get<double>()};
  }
};

TEST_F(GlobalConvergence, OfTheLeadingModesInGridDomainAndStep) {
  std::vector<std::vector<double>> rows;
  const auto keep = [&](const ModeOfCase& the_case, const Numerics& numerics, Complex lambda) {
    rows.push_back({the_case.mu, the_case.gamma, static_cast<double>(numerics.n_rho), numerics.R,
                    numerics.dt, lambda.real(), lambda.imag()});
  };
  for (const ModeOfCase& the_case : cases) {
    std::array<Complex, grids.size()> lambda;
    for (std::size_t k = 0; k < grids.size(); ++k) {
      lambda[k] = mode(the_case, grids[k]);
      keep(the_case, grids[k], lambda[k]);
    }
    for (const Numerics& numerics : others) keep(the_case, numerics, mode(the_case, numerics));
    // Richardson's estimate by the order that the last three grids show; kept as no rows.
    const double shrinks = std::abs(lambda[2] - lambda[1]) / std::abs(lambda[3] - lambda[2]);
    keep(the_case, {0, 0, 8, 0, 0.002}, lambda[3] + (lambda[3] - lambda[2]) / (shrinks - 1));
    EXPECT_GT(shrinks, 1.35) << the_case.mu << ' ' << the_case.gamma;
  }
  test::expect_reference(
      "global_convergence.csv",
      "growth rate and angular frequency of the leading flutter mode, Re = 1000, K_B = 1e-4; "
      "n_theta = 2 n_rho, with R = 16 and 32 n_theta = 120; n_rho = 0: Richardson's estimate by "
      "the order of the last three grids; gamma = 0: two dimensions, otherwise one wave along "
      "the span; data/cases/modes/global.toml, tests/validation/modes/global/convergence.cpp",
      {"mu", "gamma", "n_rho", "R", "dt", "sigma", "omega"}, rows, 0.01);
}

}  // namespace
}  // namespace pennon

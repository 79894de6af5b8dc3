/// The local theory against the paper, against its own equation, and against limits derived by
/// hand.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <random>

#include "lsa/evaluate.hpp"
#include "lsa/outcomes.hpp"
#include "lsa/two_d_ratio.hpp"
#include "lsa/verdicts.hpp"
#include "tests/support/source_folder.hpp"

namespace pennon::lsa {
namespace {

using std::numbers::pi;
constexpr double roundoff = 64 * std::numeric_limits<double>::epsilon();

// The flag of Table 1 with k_y = pi; no span: two dimensions.
Point paper(double mu, double k_x = 0) {
  return {mu, 1000, k_x, pi, 0.3, 1e-4, 0};
}

Theory with(AddedMass added_mass, Form form = Form::consistent) {
  Theory theory;
  theory.model.added_mass = added_mass;
  theory.model.form = form;
  return theory;
}

std::vector<Outcome> table_1() {
  return read_outcomes((test::source_folder() / "data/reference/table1.csv").string());
}

TEST(LocalTheory, RootsSatisfyTheDispersionRelation) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> decade(-2, 2);
  Theory theory = with(AddedMass::lamb);
  theory.model.bending = theory.model.cross_flow = true;
  for (int i = 0; i < 1000; ++i) {
    const auto any = [&] { return std::pow(10.0, decade(random)); };
    const Point p{any(), 1e3 * any(), any(), any(), 0.3, 1e-4 * any(), decade(random)};
    const Stability s = solve(p, theory);
    const double kappa = p.k_y + p.U * p.k_x;
    const double tau = 1.3 / std::sqrt(p.Re);
    const double k_squared = p.k_x * p.k_x + p.k_y * p.k_y;
    const double K = tau * (p.k_y * p.k_y + 0.3 * p.k_x * p.k_x) + p.K_B * k_squared * k_squared;
    for (const std::complex<double> omega : {s.omega_plus(), s.omega_minus()}) {
      const std::complex<double> inertia = p.mu * omega * omega;
      const std::complex<double> pressure = s.c_m * (omega - kappa) * (omega - kappa);
      const double scale = std::abs(inertia) + s.c_m * (std::norm(omega) + kappa * kappa) + K;
      EXPECT_LT(std::abs(inertia + pressure - K), roundoff * scale);
    }
  }
}

// Values of errata.md for k_y = pi and the added mass of Wu, to the digits printed there.
TEST(LocalTheory, GivesTheCriticalMassRatiosWorkedOutForTable1) {
  const Theory wu = with(AddedMass::wu);
  EXPECT_NEAR(solve(paper(0.1), wu).mu_cr, 0.044, 0.0005);
  EXPECT_NEAR(solve(paper(0.1, 2 * pi / 5), wu).mu_cr, 0.0436, 0.00005);
  EXPECT_NEAR(solve(paper(0.1, 2 * pi / 1), wu).mu_cr, 0.102, 0.0005);
}

TEST(LocalTheory, ReproducesEveryVerdictOfTable1AtPi) {
  const Sweep search{2, 7, 101, Scale::linear, {}};
  const Verdicts verdicts = compare(table_1(), paper(0.1), with(AddedMass::wu), search);
  for (const Verdict& row : verdicts.rows) EXPECT_TRUE(row.agrees()) << row.outcome.name;
  // By hand: with c_m = pi/4 (gamma = 1), mu_cr = mu where tau (1 + nu_s (2 pi/k_y)^2) = r(mu). C1
  // must be unstable, B1 stable; the other rows hold wherever these do.
  const auto border = [](double mu) {
    const double r = mu / (1 + mu / (pi / 4));
    return 2 * pi * std::sqrt(0.3 / (r * std::sqrt(1000.0) / 1.3 - 1));
  };
  ASSERT_EQ(verdicts.reproduced.size(), 1U);
  EXPECT_NEAR(verdicts.reproduced[0].first, border(0.125), roundoff);
  EXPECT_NEAR(verdicts.reproduced[0].second, border(0.075), roundoff);
}

TEST(LocalTheory, CallsB1UnstableAtTwoPiAgainstTheTable) {
  Point point = paper(0.1);
  point.k_y = 2 * pi;
  const Verdicts verdicts = compare(table_1(), point, with(AddedMass::wu), {2, 7, 101, {}, {}});
  for (const Verdict& row : verdicts.rows)
    EXPECT_EQ(row.agrees(), row.outcome.name != "B1") << row.outcome.name;
}

TEST(LocalTheory, HasNoGrowthAtTheCriticalMassRatioAndGrowthAboveIt) {
  for (const AddedMass kind : {AddedMass::two_d, AddedMass::wu, AddedMass::lamb}) {
    const double mu_cr = solve(paper(1, 1.5), with(kind)).mu_cr;
    EXPECT_NEAR(solve(paper(mu_cr, 1.5), with(kind)).P, 0, roundoff);
    EXPECT_TRUE(solve(paper(mu_cr * (1 + 1e-12), 1.5), with(kind)).is_unstable());
    EXPECT_FALSE(solve(paper(mu_cr * (1 - 1e-12), 1.5), with(kind)).is_unstable());
  }
}

TEST(LocalTheory, HasNoCriticalMassRatioWhereTheRestoringForcesHoldTheFlow) {
  Point stiff = paper(1e6, 50);
  stiff.Re = 1e-2;
  EXPECT_TRUE(std::isnan(solve(stiff, with(AddedMass::lamb)).mu_cr));
  EXPECT_FALSE(solve(stiff, with(AddedMass::lamb)).is_unstable());
}

TEST(LocalTheory, IsTheVibratingMembraneWhereTheFluidHasNoMass) {
  // mu >> c_m in still fluid's limit: omega^2 mu = K.
  const Point heavy = paper(1e12, 2);
  const Stability s = solve(heavy, with(AddedMass::lamb));
  const double K = 1.3 / std::sqrt(1000.0) * (pi * pi + 0.3 * 4);
  // The product of the roots is (K - c_m k_y^2)/mu without a stream; with it, the drift stays.
  EXPECT_NEAR(s.omega_plus().real() + s.omega_minus().real(), 2 * s.c_m * pi / (1e12 + s.c_m),
              roundoff);
  EXPECT_NEAR(-(s.omega_plus() * s.omega_minus()).real() * 1e12, K - s.c_m * pi * pi,
              1e-9 * s.c_m * pi * pi);
}

TEST(LocalTheory, FollowsACrossFlowOnlyThroughTheStreamAlongTheWave) {
  // Turn the stream: U along x and V along y act on a wave as their sum along its wavenumber.
  Theory theory = with(AddedMass::lamb);
  theory.model.cross_flow = true;
  Point p = paper(0.1, 2.0);
  p.nu_s = 0.3;
  p.U = 0.7;
  Point straight = p;
  straight.U = 0;
  const Coefficients turned = coefficients(p, theory);
  const Coefficients plain = coefficients(straight, theory);
  EXPECT_DOUBLE_EQ(turned.kappa, pi + 0.7 * 2.0);
  EXPECT_EQ(turned.K, plain.K);
  // A stream that runs along the crests does nothing but tension: two real roots, +-
  // (K/(mu+c_m))^1/2.
  p.U = -pi / 2.0;
  const Stability crest = solve(p, theory);
  EXPECT_NEAR(crest.omega_r_plus, std::sqrt(plain.K / (0.1 + plain.c_m)), 1e-15);
  EXPECT_NEAR(crest.omega_r_minus, -std::sqrt(plain.K / (0.1 + plain.c_m)), 1e-15);
}

TEST(LocalTheory, LeavesBendingAndCrossFlowOutUnlessAsked) {
  Point p = paper(0.1, 2);
  const Stability without = solve(p, with(AddedMass::wu));
  p.K_B = 10;
  p.U = 3;
  EXPECT_EQ(solve(p, with(AddedMass::wu)).P, without.P);
  Theory bending = with(AddedMass::wu);
  bending.model.bending = true;
  EXPECT_GT(solve(p, bending).P, without.P);
}

TEST(LocalTheory, TakesTheTensionWhereItIsAskedFor) {
  Model model;
  EXPECT_DOUBLE_EQ(tension_times_sqrt_Re(model), 1.3);
  model.tension_at = 0.25;
  EXPECT_DOUBLE_EQ(tension_times_sqrt_Re(model), 1.3 * 0.5);
  model.tension_at = 1;
  EXPECT_DOUBLE_EQ(tension_times_sqrt_Re(model), 0) << "the free edge carries nothing";
  model.form = Form::as_printed;
  EXPECT_DOUBLE_EQ(tension_times_sqrt_Re(model), 1.3) << "the printed profile is largest at y = L";
}

TEST(LocalTheory, KeepsThePrintedFormsByName) {
  const Point p = paper(0.1, 2);
  const Stability consistent = solve(p, with(AddedMass::wu));
  const Stability printed = solve(p, with(AddedMass::wu, Form::as_printed));
  const double tau = 1.3 / std::sqrt(1000.0);
  const double A = 0.3 * tau * 4;
  const double B = tau * pi * pi;
  const double c_m = pi * pi / 4;  // gamma = pi
  EXPECT_EQ(printed.P, consistent.P);
  EXPECT_EQ(printed.omega_plus(), consistent.omega_plus());
  EXPECT_NEAR(printed.mu_cr, c_m * (A + B) / (c_m * pi * pi - A + B), roundoff);
  EXPECT_NEAR(consistent.mu_cr, c_m * (A + B) / (c_m * pi * pi - A - B), roundoff);
  EXPECT_NEAR(printed.growth, std::sqrt(-printed.P), roundoff);
  EXPECT_NEAR(consistent.growth, c_m * pi / (0.1 + c_m) * std::sqrt(-consistent.P), roundoff);
}

TEST(LocalTheory, ExpandsAboutTwoDimensionsExactlyAtEqualAddedMass) {
  const Point p = paper(0.1, 1.5);
  const Theory theory = with(AddedMass::two_d);  // c_m does not depend on k_x
  const TwoDRatio ratio = two_d_ratio(p, theory);
  EXPECT_NEAR(ratio.P_expansion, solve(p, theory).P, roundoff) << "(4.11a)";
  EXPECT_NEAR(ratio.frequency_ratio, 1, roundoff) << "(4.10)";
}

TEST(LocalTheory, ExpandsTheGrowthToFirstOrder) {
  const Theory theory = with(AddedMass::two_d);
  double previous = 0;
  for (const double k_x : {0.4, 0.2, 0.1}) {  // the error falls as k_x^4: by 16 for each halving
    const TwoDRatio ratio = two_d_ratio(paper(0.1, k_x), theory);
    const double error = std::abs(ratio.growth_ratio_expansion - ratio.growth_ratio);
    if (previous > 0) {
      EXPECT_NEAR(previous / error, 16, 1);
    }
    previous = error;
  }
}

TEST(LocalTheory, HasThePaperFrequencyRatioForHeavyFlagsOnly) {
  const auto ratio = [](double mu) {
    return two_d_ratio(paper(mu, 2), with(AddedMass::lamb)).frequency_ratio;
  };
  const double printed =
      two_d_ratio(paper(1, 2), with(AddedMass::lamb, Form::as_printed)).frequency_ratio;
  EXPECT_NEAR(ratio(1e4), printed, 1e-4);
  EXPECT_GT(std::abs(ratio(0.1) - printed), 0.1);
}

}  // namespace
}  // namespace pennon::lsa

// Where a cross-flow meets a wave along the span the spectrum is not symmetric about omega = 0:
// neutral modes and maps with frequencies of either sign, on a small grid.
#include <gtest/gtest.h>

#include "modes/global/map/sampled_fit.hpp"
#include "modes/global/study/growth_map.hpp"
#include "modes/global/study/linearisation.hpp"
#include "modes/global/study/neutral_curve.hpp"
#include "tests/support/small_flag_flow.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr double k_x = 1.5, U = 0.25;
const FlagParameters flag{.mu = 1, .K_B = 1e-3, .gamma = {}};

FlowParameters flow_of(double its_U) {
  return {.Re = 200, .U = its_U};
}

Settings settings_of(double its_k_x) {
  Settings settings;
  settings.is_given = true;
  settings.n_modes = 0;
  settings.k_x = its_k_x;
  settings.neutral = {.is_given = true,
                      .K_B = Sweep{.list = {{1e-3, 2e-3}}},
                      .mu = {0.02, 2},
                      .omega = {1, 10},
                      .branches = 4,
                      .check = false};
  settings.map = {.is_given = true,
                  .mu = Sweep{.list = {{0.2, 0.4, 0.8}}},
                  .K_B = Sweep{.list = {{1e-3, 2e-3}}},
                  .omega = {1, 10}};
  return resolve(settings, flag, test::small_discretisation);
}

Linearisation linearisation_of(double its_k_x, double its_U) {
  return Linearisations(flag, flow_of(its_U), settings_of(its_k_x), CurveParameter::K_B,
                        umfpack_factors())
      .at(1e-3);
}

NeutralCurve curve_of(double its_k_x, double its_U) {
  const EigenSolver none = [](const CoupledOperator&, Complex, int, bool) { return Spectrum{}; };
  return neutral_curve(flag, flow_of(its_U), settings_of(its_k_x), none, umfpack_factors());
}

TEST(GlobalBothSigns, AReversedCrossFlowOrWaveConjugatesTheResponse) {
  const Complex lambda(0.3, 2.5);
  Linearisation here = linearisation_of(k_x, U), other_wave = linearisation_of(-k_x, U),
                other_flow = linearisation_of(k_x, -U);
  const Eigen::MatrixXcd F = here.F.at(lambda);
  const auto difference = [&](Linearisation& other) {
    return (other.F.at(std::conj(lambda)).conjugate() - F).norm() / F.norm();
  };
  EXPECT_LT(difference(other_wave), 1e-9);
  EXPECT_LT(difference(other_flow), 1e-9);
  // And the spectrum is not symmetric.
  EXPECT_GT(difference(here), 1e-3);
}

TEST(GlobalBothSigns, NeutralModesWithNegativeFrequenciesAreEigenvaluesOfTheWholeOperator) {
  Linearisation linearised = linearisation_of(k_x, U);
  std::size_t found = 0;
  for (const Interval& window : frequency_windows({1, 10}, false)) {
    const SampledFit fit =
        sampled_fit([&](Complex lambda) { return linearised.F.at(lambda); }, window, 1e-5, 60);
    for (const NeutralMode& start :
         neutral_modes(fit.aerodynamics(), linearised.flag, window, {0.02, 2})) {
      const auto mode =
          neutral_mode(linearised.aerodynamics(), linearised.flag, start.omega, start.mu);
      ASSERT_TRUE(mode);
      EXPECT_TRUE(window.contains(mode->omega));
      const CoupledOperator whole = linearised.with_mass_ratio(mode->mu);
      const Complex lambda = eigenpair_near(whole.assembled(), Complex(0, mode->omega)).lambda;
      EXPECT_LT(std::abs(lambda - Complex(0, mode->omega)), 1e-7) << mode->mu;
      // A little more mass.
      constexpr double h = 1e-5;
      const CoupledOperator heavier = linearised.with_mass_ratio(mode->mu + h);
      const Complex change =
          (eigenpair_near(heavier.assembled(), lambda + mode->by_mu * h).lambda - lambda) / h;
      EXPECT_LT(std::abs(change - mode->by_mu), 1e-2 * std::abs(mode->by_mu));
      if (mode->omega < 0) ++found;
    }
  }
  EXPECT_GT(found, 0u);
}

TEST(GlobalBothSigns, TheCurveHasTheSmallerOfBothAndIsMirroredWhereTheCrossFlowIs) {
  const NeutralCurve along = curve_of(k_x, U), against = curve_of(k_x, -U);
  ASSERT_EQ(along.points.size(), 2u);
  ASSERT_EQ(against.points.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const std::vector<BranchPoint>&one = along.points[i].modes, &two = against.points[i].modes;
    ASSERT_EQ(one.size(), two.size());
    bool has_negative = false, has_positive = false;
    for (std::size_t k = 0; k < one.size(); ++k) {
      EXPECT_NEAR(one[k].mode.mu, two[k].mode.mu, 1e-8 * two[k].mode.mu);
      EXPECT_NEAR(one[k].mode.omega, -two[k].mode.omega, 1e-6);
      EXPECT_LT(one[k].residual, 1e-6);
      has_negative |= one[k].mode.omega < 0;
      has_positive |= one[k].mode.omega > 0;
    }
    EXPECT_TRUE(has_negative && has_positive);
  }
}

TEST(GlobalBothSigns, TheMapHasTheModeThatGrowsMostOfBoth) {
  const Settings settings = settings_of(k_x);
  const GrowthMap map = growth_map(flag, flow_of(U), settings, umfpack_factors());
  const GrowthMap mirrored = growth_map(flag, flow_of(-U), settings, umfpack_factors());
  const Linearisations linearisations(flag, flow_of(U), settings, CurveParameter::K_B,
                                      umfpack_factors());
  for (std::size_t i = 0; i < map.x.size(); ++i)
    for (std::size_t m = 0; m < map.mu.size(); ++m) {
      const Complex lambda(map.growth[m][i], map.omega[m][i]);
      EXPECT_NEAR(mirrored.growth[m][i], lambda.real(), 1e-4);
      EXPECT_NEAR(mirrored.omega[m][i], -lambda.imag(), 1e-4);
      const Linearisation linearised = Linearisations(linearisations).at(map.x[i]);
      const CoupledOperator whole = linearised.with_mass_ratio(map.mu[m]);
      EXPECT_LT(std::abs(eigenpair_near(whole.assembled(), lambda).lambda - lambda), 2e-5);
      // The wave that travels the other way, from where it is without a cross-flow.
      const Complex other =
          eigenpair_near(whole.assembled(), {lambda.real() - 0.1, -lambda.imag()}).lambda;
      if (other.imag() * lambda.imag() < 0) {
        EXPECT_LT(other.real(), lambda.real());
      }
    }
}

TEST(GlobalBothSigns, OneIsEnoughWhereTheSpectrumIsSymmetric) {
  const GrowthMap still = growth_map(flag, flow_of(0), settings_of(k_x), umfpack_factors()),
                  crossed = growth_map(flag, flow_of(U), settings_of(0), umfpack_factors());
  for (const GrowthMap* map : {&still, &crossed})
    for (const std::vector<double>& row : map->omega)
      for (const double omega : row) EXPECT_GT(omega, 0);
  Linearisation linearised = linearisation_of(0, U);
  const Complex lambda(0.3, 2.5);
  const Eigen::MatrixXcd F = linearised.F.at(lambda);
  EXPECT_LT((linearised.F.at(std::conj(lambda)).conjugate() - F).norm(), 1e-9 * F.norm());
}

}  // namespace
}  // namespace pennon::modes::global

/// What holds for the modes of every family: norm, orthogonality, edges, order.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "modes/normal/bessel_zero.hpp"
#include "modes/normal/gauss_legendre.hpp"
#include "tests/support/mode_families.hpp"

namespace pennon::modes {
namespace {

using test::families;
using test::flag;
using test::flow;
// Of sums of some thousand terms of the order of 1.
constexpr double roundoff = 1e-13;

double product(const NormalModes& family, const NormalMode& a, const NormalMode& b) {
  double sum = 0;
  for (const QuadraturePoint& point : gauss_legendre(family.panels))
    sum += point.weight * family.weight(point.y) * a.shape(point.y) * b.shape(point.y);
  return sum;
}

TEST(NormalModes, AreOrthogonalAndHaveTheNormTheySay) {
  for (const NormalModes& family : families({{0, 3}, 6}, 100))
    for (const NormalMode& a : family.modes)
      for (const NormalMode& b : family.modes) {
        if (a.n != b.n) continue;
        EXPECT_NEAR(product(family, a, b), a.m == b.m ? a.norm_squared : 0, roundoff)
            << "family " << static_cast<int>(family.family) << ", n = " << a.n << ", m = " << a.m
            << " and " << b.m;
      }
}

TEST(NormalModes, OfHighRankAreIntegratedAsWell) {
  // alpha is about 1000, so roundoff in y shifts a wave's phase by 1e-13.
  constexpr double phase_roundoff = 1e-12;
  const ModeRange high{{0, 60}, 300};
  for (const NormalModes& family :
       {bessel_modes(high, flag(), flow), hanging_chain_modes(high, flag(), flow)}) {
    const NormalMode& last = family.modes.back();
    const NormalMode& one_before = family.modes[family.modes.size() - 2];
    EXPECT_NEAR(product(family, last, last) / last.norm_squared, 1, phase_roundoff);
    EXPECT_NEAR(product(family, last, one_before), 0, phase_roundoff);
  }
}

TEST(NormalModes, AreHeldAtTheLeadingEdgeAndMoveUpwardAtTheTrailingOne) {
  for (const NormalModes& family : families({{0}, 6}, 100))
    for (const NormalMode& mode : family.modes) {
      EXPECT_NEAR(mode.shape(0), 0, roundoff);
      EXPECT_GT(mode.shape(1), 0);
    }
}

TEST(NormalModes, AreListedByWavesThenRankWithRisingFrequencies) {
  for (const NormalModes& family : families({{0, 1, 4}, 5}, 100)) {
    ASSERT_EQ(family.modes.size(), 15u);
    for (std::size_t i = 0; i < family.modes.size(); ++i) {
      const NormalMode& mode = family.modes[i];
      EXPECT_EQ(mode.n, std::vector<int>({0, 1, 4})[i / 5]);
      EXPECT_EQ(mode.m, static_cast<int>(i % 5) + 1);
      EXPECT_DOUBLE_EQ(mode.k_x, std::numbers::pi * mode.n);
      if (mode.m > 1) {
        EXPECT_GT(mode.omega, family.modes[i - 1].omega);
      }
    }
  }
}

TEST(NormalModes, HaveOneMoreNodeThanTheModeBefore) {
  for (const NormalModes& family : families({{0}, 6}, 100))
    for (const NormalMode& mode : family.modes) {
      int nodes = 0;
      constexpr int intervals = 1000;
      for (int i = 1; i < intervals; ++i)
        if (mode.shape(static_cast<double>(i) / intervals) * mode.shape((i + 1.0) / intervals) < 0)
          ++nodes;
      EXPECT_EQ(nodes, mode.m - 1);
    }
}

TEST(BesselModes, SwingAsTheWaveSpeedTimesTheZero) {
  const double c = std::sqrt(1.3 / std::sqrt(1000.0) / 0.125);
  for (const NormalMode& mode : bessel_modes({{0, 2}, 3}, flag(), flow).modes) {
    EXPECT_DOUBLE_EQ(mode.omega, c * bessel_zero(mode.n, mode.m));
    EXPECT_EQ(mode.alpha, bessel_zero(mode.n, mode.m));
  }
}

TEST(BesselModes, WithSpanwiseWavesVanishAtTheTrailingEdge) {
  for (const NormalMode& mode : bessel_modes({{1, 2}, 3}, flag(), flow).modes)
    EXPECT_EQ(mode.shape(1), 0);
}

TEST(HangingChainModes, SwingAsTensionOverMass) {
  const double T_0 = 1.3 / std::sqrt(1000.0);
  for (const NormalMode& mode : hanging_chain_modes({{0, 2}, 3}, flag(), flow).modes) {
    const double alpha = bessel_zero(0, mode.m);
    EXPECT_NEAR(
        0.125 * mode.omega * mode.omega / (T_0 * (alpha * alpha / 4 + 0.3 * mode.k_x * mode.k_x)),
        1, roundoff);
  }
}

TEST(InVacuoModes, WithNeitherTensionNorBendingAreRefused) {
  FlagParameters limp = flag();
  limp.K_B = 0;
  EXPECT_THROW(in_vacuo_modes({{0}, 1}, limp, {}, TensionProfile::blasius, 40), InputError);
}

TEST(InVacuoModes, MoreThanTheElementsResolveAreRefused) {
  EXPECT_THROW(in_vacuo_modes({{0}, 21}, flag(), flow, TensionProfile::blasius, 40), InputError);
}

TEST(InVacuoModes, ThatFewerElementsWouldChangeAreRefused) {
  try {
    in_vacuo_modes({{0}, 20}, flag(), flow, TensionProfile::blasius, 40);
    FAIL();
  } catch (const SolverError& error) {
    EXPECT_NE(std::string(error.what()).find("take more elements"), std::string::npos)
        << error.what();
  }
}

TEST(InVacuoModes, WithoutAStreamHaveNoAlpha) {
  const NormalModes family = in_vacuo_modes({{0}, 2}, flag(), {}, TensionProfile::blasius, 40);
  EXPECT_TRUE(std::isnan(family.modes[0].alpha));
  EXPECT_GT(family.modes[1].omega, 0);
}

}  // namespace
}  // namespace pennon::modes

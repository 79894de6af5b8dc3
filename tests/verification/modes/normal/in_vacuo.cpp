/// The modes in vacuum against exact ones, their convergence, and their extremes.
#include "modes/normal/in_vacuo.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "modes/normal/bessel.hpp"
#include "modes/normal/hanging_chain.hpp"
#include "modes/normal/tension.hpp"

namespace pennon::modes {
namespace {

constexpr int modes = 20;
constexpr int elements = 200;  // the default of a case
// What the default promises for the first 20 modes, and what it keeps for exact solutions.
constexpr double promised = 1e-11;
constexpr double reached = 1e-13;

FlagParameters membrane() {
  FlagParameters flag;
  flag.mu = 0.125;
  flag.gamma = 2;
  return flag;
}
const FlowParameters flow{1000, 0};

FlagParameters beam(double K_B, LeadingEdge leading_edge) {
  FlagParameters flag;
  flag.mu = 0.125;
  flag.K_B = K_B;
  flag.leading_edge = leading_edge;
  return flag;
}

std::vector<double> frequencies(const NormalModes& family) {
  std::vector<double> omega;
  for (const NormalMode& mode : family.modes) omega.push_back(mode.omega);
  return omega;
}

// The largest relative difference.
double difference(const std::vector<double>& found, const std::vector<double>& exact) {
  double largest = 0;
  for (std::size_t i = 0; i < found.size(); ++i)
    largest = std::max(largest, std::abs(found[i] / exact[i] - 1));
  return largest;
}

// The roots of cos b + 1/cosh b = 0 near (m - 1/2) pi, by Newton's method.
double clamped_free_root(int m) {
  double b = (m - 0.5) * std::numbers::pi;
  for (int step = 0; step < 20; ++step)
    b += (std::cos(b) + 1 / std::cosh(b)) / (std::sin(b) + std::tanh(b) / std::cosh(b));
  return b;
}

// The roots of tan b = tanh b near (m + 1/4) pi.
double pinned_free_root(int m) {
  double b = (m + 0.25) * std::numbers::pi;
  for (int step = 0; step < 20; ++step) {
    const double tanh = std::tanh(b);
    b -= (std::sin(b) - tanh * std::cos(b)) /
         (std::cos(b) + tanh * std::sin(b) - (1 - tanh * tanh) * std::cos(b));
  }
  return b;
}

std::vector<double> beam_frequencies(double K_B, double mu, double (*root)(int)) {
  std::vector<double> omega;
  for (int m = 1; m <= modes; ++m) omega.push_back(root(m) * root(m) * std::sqrt(K_B / mu));
  return omega;
}

TEST(InVacuoModes, UnderLinearTensionAreThoseOfTheHangingChain) {
  for (const int n : {0, 1, 5, 159}) {
    const ModeRange range{{n}, modes};
    EXPECT_LT(difference(frequencies(in_vacuo_modes(range, membrane(), flow, TensionProfile::linear,
                                                    elements)),
                         frequencies(hanging_chain_modes(range, membrane(), flow))),
              reached)
        << "n = " << n;
  }
}

TEST(InVacuoModes, OfTheWedgeAreTheBesselModes) {
  for (const int n : {0, 1, 2, 5, 20}) {
    const ModeRange range{{n}, modes};
    EXPECT_LT(difference(frequencies(in_vacuo_modes(range, membrane(), flow, TensionProfile::wedge,
                                                    elements)),
                         frequencies(bessel_modes(range, membrane(), flow))),
              reached)
        << "n = " << n;
  }
}

TEST(InVacuoModes, OfTheWedgeHaveTheBesselShapes) {
  const ModeRange range{{0, 2}, 5};
  const NormalModes found =
      in_vacuo_modes(range, membrane(), flow, TensionProfile::wedge, elements);
  const NormalModes exact = bessel_modes(range, membrane(), flow);
  for (std::size_t i = 0; i < found.modes.size(); ++i)
    for (const double y : {0.1, 0.45, 0.8, 0.99})
      EXPECT_NEAR(found.modes[i].shape(y),
                  exact.modes[i].shape(y) / std::sqrt(exact.modes[i].norm_squared), 1e-12)
          << "mode " << i << ", y = " << y;
}

TEST(InVacuoModes, UnderConstantTensionAreThoseOfAString) {
  const double c = std::sqrt(leading_edge_tension(flow.Re) / membrane().mu);
  std::vector<double> exact;
  for (int m = 1; m <= modes; ++m) exact.push_back((m - 0.5) * std::numbers::pi * c);
  EXPECT_LT(difference(frequencies(in_vacuo_modes({{0}, modes}, membrane(), flow,
                                                  TensionProfile::constant, elements)),
                       exact),
            reached);
}

TEST(InVacuoModes, OfAClampedBeamAreEulerAndBernoullis) {
  for (const double K_B : {1e-4, 1.0, 1e4})
    EXPECT_LT(difference(frequencies(in_vacuo_modes({{0}, modes}, beam(K_B, LeadingEdge::clamped),
                                                    {}, TensionProfile::blasius, elements)),
                         beam_frequencies(K_B, 0.125, clamped_free_root)),
              reached)
        << "K_B = " << K_B;
}

TEST(InVacuoModes, OfAPinnedBeamBeginWithARotationThatTakesNoEnergy) {
  const NormalModes found = in_vacuo_modes({{0}, modes + 1}, beam(1, LeadingEdge::pinned), {},
                                           TensionProfile::blasius, elements);
  std::vector<double> omega = frequencies(found);
  EXPECT_LT(omega[0], 1e-12 * omega[1]);
  EXPECT_NEAR(found.modes[0].shape(0.5), std::sqrt(3) / 2, 1e-12);  // Y = sqrt(3) y
  omega.erase(omega.begin());
  EXPECT_LT(difference(omega, beam_frequencies(1, 0.125, pinned_free_root)), reached);
}

TEST(InVacuoModes, ConvergeWithTheSixteenthPowerOfTheElementSize) {
  // The hanging chain's 20th frequency, whose error is above roundoff for these elements.
  const FlagParameters flag = membrane();
  const double T_0 = leading_edge_tension(flow.Re);
  const double exact = hanging_chain_modes({{0}, modes}, flag, flow).modes.back().omega;
  const auto error = [&](int count) {
    const ChordwiseShapes shapes =
        solve(chordwise_problem(TensionProfile::linear, 0, T_0, flag),
              spline_space(TensionProfile::linear, count, 0, T_0, flag), modes, "chain");
    return std::abs(std::sqrt(shapes.lambda.back() / flag.mu) / exact - 1);
  };
  const double coarse = error(40);
  const double middle = error(56);
  const double fine = error(80);
  EXPECT_GT(std::log(coarse / middle) / std::log(56.0 / 40), 14);
  EXPECT_GT(std::log(middle / fine) / std::log(80.0 / 56), 14);
}

TEST(InVacuoModes, ApproachTheMembraneAsBendingVanishes) {
  const std::vector<double> limp =
      frequencies(in_vacuo_modes({{0, 1}, 5}, membrane(), flow, TensionProfile::blasius, elements));
  double before = 1;
  for (const double K_B : {1e-6, 1e-8, 1e-10, 1e-12}) {
    FlagParameters flag = membrane();
    flag.K_B = K_B;
    flag.leading_edge = LeadingEdge::clamped;
    const double change = difference(
        frequencies(in_vacuo_modes({{0, 1}, 5}, flag, flow, TensionProfile::blasius, elements)),
        limp);
    EXPECT_LT(change, before) << "K_B = " << K_B;
    before = change;
  }
  // The clamped edge shifts the pinned point by the layer's length sqrt(K_B/T_0).
  EXPECT_LT(before, 2 * std::sqrt(1e-12 / leading_edge_tension(flow.Re)));
}

TEST(InVacuoModes, AreFoundAtTheExtremesOfBendingTensionAndSpan) {
  // in_vacuo_modes itself refuses frequencies that fewer elements would change by over 1e-9.
  for (const double K_B : {0.0, 1e-30, 1e-4, 1e4})
    for (const double Re : {1e-6, 1e3, 1e30})
      for (const double k_x : {0.0, 1e3})
        for (const LeadingEdge edge : {LeadingEdge::pinned, LeadingEdge::clamped}) {
          FlagParameters flag = beam(K_B, edge);
          if (k_x > 0) flag.gamma = 2 * std::numbers::pi / k_x;
          const NormalModes family = in_vacuo_modes({{k_x > 0 ? 1 : 0}, 3}, flag, {Re, 0},
                                                    TensionProfile::blasius, k_x > 0 ? 300 : 100);
          for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_TRUE(std::isfinite(family.modes[i].omega));
            if (i > 0) {
              EXPECT_GT(family.modes[i].omega, family.modes[i - 1].omega);
            }
          }
        }
}

TEST(InVacuoModes, ScaleWithTheSquareRootOfStiffnessOverMass) {
  FlagParameters flag = membrane();
  flag.K_B = 1e-4;
  FlagParameters heavy = flag;
  heavy.mu = 1e6 * flag.mu;
  const std::vector<double> light_omega =
      frequencies(in_vacuo_modes({{0, 1}, 5}, flag, flow, TensionProfile::blasius, 80));
  std::vector<double> heavy_omega =
      frequencies(in_vacuo_modes({{0, 1}, 5}, heavy, flow, TensionProfile::blasius, 80));
  for (double& omega : heavy_omega) omega *= 1e3;
  EXPECT_LT(difference(heavy_omega, light_omega), promised);
}

}  // namespace
}  // namespace pennon::modes

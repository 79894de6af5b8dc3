// Neutral modes and what they are found with: the fluid's response, its rational fit.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <complex>

#include "common/errors.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/map/rational_fit.hpp"
#include "modes/global/map/sampled_fit.hpp"
#include "modes/global/neutral/flag_mode.hpp"
#include "modes/global/neutral/neutral.hpp"
#include "modes/global/solve/aerodynamic_matrix.hpp"
#include "modes/global/solve/spectrum.hpp"
#include "tests/support/small_flag_flow.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

// Two poles with residues of rank one, and a polynomial.
Eigen::MatrixXcd known_function(Complex s) {
  Eigen::Matrix2cd R, Q, P;
  R << 1, 2, 2, 4;
  Q << Complex(0, 1), 0, 3, 0;
  P << 0.5, -1, 0, 2;
  return R / (s + 1.0) + Q / (s - Complex(-0.3, 4)) + P * s;
}

std::vector<MatrixSample> samples_of(int count) {
  std::vector<MatrixSample> samples;
  for (int i = 0; i < count; ++i) {
    const Complex s(0, 1 + 0.7 * i);
    samples.push_back({s, known_function(s)});
  }
  return samples;
}

TEST(GlobalRationalFit, IsARationalFunctionOfItsDegreeItself) {
  const RationalFit fit(samples_of(9), 1e-12);
  EXPECT_EQ(fit.support_points(), 4u);  // three poles, one of them at infinity
  EXPECT_LT(fit.error_at_samples(), 1e-12);
  for (const Complex s : {Complex(0, 2.1), Complex(0.4, 5), Complex(-0.2, 1), Complex(2, -3)})
    EXPECT_LT((fit(s) - known_function(s)).norm(), 1e-9 * known_function(s).norm()) << s;
}

TEST(GlobalRationalFit, HasTheDerivativeOfItsDifferencesAtASupportPointToo) {
  const std::vector<MatrixSample> samples = samples_of(9);
  const RationalFit fit(samples, 1e-12);
  constexpr double h = 1e-5;
  for (const Complex s : {samples[0].lambda, samples[8].lambda, Complex(0.1, 3.3)}) {
    const Eigen::MatrixXcd difference = (known_function(s + h) - known_function(s - h)) / (2 * h);
    for (int i = 0; i < 2; ++i) {
      const Eigen::Vector2cd unit = Eigen::Vector2cd::Unit(i);
      EXPECT_LT((fit.derivative(s, unit) - difference.col(i)).norm(), 1e-7 * difference.norm())
          << s;
    }
  }
}

TEST(GlobalSampledFit, SaysAnErrorThatHoldsBetweenItsSamples) {
  int asked = 0;
  // Of a delay too: no rational function.
  const auto F = [&](Complex s) {
    ++asked;
    return Eigen::MatrixXcd(known_function(s) * (1.0 + std::exp(-1.5 * s)));
  };
  const SampledFit found = sampled_fit(F, {1, 9}, 1e-6, 60);
  EXPECT_EQ(found.samples.size(), static_cast<std::size_t>(asked));
  EXPECT_LE(found.error, 1e-6);
  double scale = 0, largest = 0;
  for (double omega = 1; omega <= 9; omega += 0.0625) {
    const Complex s(0, omega);
    scale = std::max(scale, F(s).norm());
    largest = std::max(largest, (found.fit(s) - F(s)).norm());
  }
  EXPECT_LT(largest / scale, 1e-6);
}

TEST(GlobalSampledFit, SaysSoWhereTheSamplesDoNotSuffice) {
  const auto F = [](Complex s) {
    return Eigen::MatrixXcd(Eigen::MatrixXcd::Identity(2, 2) * std::exp(-40.0 * s));
  };
  try {
    sampled_fit(F, {1, 9}, 1e-6, 15);
    FAIL() << "no error";
  } catch (const SolverError& fault) {
    EXPECT_NE(std::string(fault.what()).find("by 15 samples"), std::string::npos) << fault.what();
  }
}

// Two oscillators mu z'' + k z = F z with F = -c lambda - lambda^3: neutral at omega^2 = c, with
// mu = k/c; the growth rate by a root of lambda^3 + mu lambda^2 + c lambda + k = 0.
struct Oscillators {
  double c[2] = {4, 9}, k[2] = {2, 1.8};

  FlagOperator flag() const {
    FlagOperator flag{Eigen::VectorXd::Ones(2), Eigen::MatrixXcd::Zero(2, 2)};
    flag.stiffness(0, 0) = k[0];
    flag.stiffness(1, 1) = k[1];
    return flag;
  }
  Aerodynamics aerodynamics() const {
    return [c = c](Complex s) {
      Eigen::MatrixXcd F = Eigen::MatrixXcd::Zero(2, 2), slope = F;
      for (int i = 0; i < 2; ++i) {
        F(i, i) = -c[i] * s - s * s * s;
        slope(i, i) = -c[i] - 3.0 * s * s;
      }
      return Response{F,
                      [slope](const Eigen::VectorXcd& z) { return Eigen::VectorXcd(slope * z); }};
    };
  }
  Complex root(int i, double mu) const {
    Eigen::Matrix3d companion;
    companion << 0, 0, -k[i], 1, 0, -c[i], 0, 1, -mu;
    const Eigen::Vector3cd roots = companion.eigenvalues();
    Eigen::Index upper = 0;
    roots.imag().maxCoeff(&upper);
    return roots[upper];
  }
};

TEST(GlobalNeutralModes, OfTwoOscillatorsAreBothFoundWithTheirGrowthByTheMassRatio) {
  const Oscillators two;
  const std::vector<NeutralMode> found =
      neutral_modes(two.aerodynamics(), two.flag(), {0.5, 6}, {0.01, 1});
  ASSERT_EQ(found.size(), 2u);
  for (int n = 0; n < 2; ++n) {
    const int i = 1 - n;  // the smaller mu first
    EXPECT_NEAR(found[n].mu, two.k[i] / two.c[i], 1e-12);
    EXPECT_NEAR(found[n].omega, std::sqrt(two.c[i]), 1e-10);
    constexpr double h = 1e-5;
    const Complex difference =
        (two.root(i, found[n].mu + h) - two.root(i, found[n].mu - h)) / (2 * h);
    EXPECT_LT(std::abs(found[n].by_mu - difference), 1e-7);
  }
  EXPECT_TRUE(neutral_modes(two.aerodynamics(), two.flag(), {0.5, 1.5}, {0.01, 1}).empty());
  EXPECT_EQ(neutral_modes(two.aerodynamics(), two.flag(), {0.5, 6}, {0.3, 1}).size(), 1u);
}

TEST(GlobalFlagMode, OfAnOscillatorIsTheRootOfItsPolynomialWithItsSlope) {
  const Oscillators two;
  constexpr double mu = 0.7, h = 1e-5;
  const Complex root = two.root(1, mu);
  Eigen::VectorXcd zeta(2);
  zeta << 0.3, 1;
  const auto mode = flag_mode(two.aerodynamics(), two.flag(), mu, root + Complex(0.1, 0.2), zeta);
  ASSERT_TRUE(mode);
  EXPECT_LT(std::abs(mode->lambda - root), 1e-12);
  EXPECT_LT(std::abs(mode->zeta[0]), 1e-12);
  EXPECT_LT(std::abs(mode->by_mu - (two.root(1, mu + h) - two.root(1, mu - h)) / (2 * h)), 1e-7);
}

constexpr int n_theta = 24;
constexpr double K_B = 1e-3;

TEST(GlobalAerodynamicMatrix, MakesTheFlagAloneHaveTheModesOfTheCoupledOperator) {
  for (const auto& [k_x, U] : {std::pair(0.0, 0.0), std::pair(2.0, 0.0), std::pair(2.0, 0.5)}) {
    const test::SmallFlow small(n_theta, k_x, U);
    constexpr double mu = 0.3;
    const CoupledOperator coupled = small.coupled(K_B, mu);
    const Eigenpair pair = eigenpair_near(coupled.assembled(), {0, 3});
    const FlagOperator flag = small.flag(K_B, mu);
    AerodynamicMatrix F(coupled.shared_fluid(), umfpack_factors());
    const Eigen::VectorXcd zeta = pair.q.segment(coupled.zeta(0), coupled.flag_nodes());
    const Eigen::MatrixXcd at = F.at(pair.lambda);
    const Eigen::VectorXcd force = at * zeta;
    const Eigen::VectorXcd inertia = pair.lambda * pair.lambda * flag.mass.cwiseProduct(zeta);
    EXPECT_LT((inertia + flag.stiffness * zeta - force).norm(), 1e-8 * force.norm());
    EXPECT_LT((F.mode(zeta) - pair.q).norm(), 1e-8 * pair.q.norm());

    const Eigen::VectorXcd derivative = F.derivative(zeta);
    constexpr double h = 1e-5;
    const Eigen::VectorXcd difference =
        (F.at(pair.lambda + h) - F.at(pair.lambda - h)) * zeta / (2 * h);
    EXPECT_LT((derivative - difference).norm(), 1e-7 * difference.norm());
  }
}

// Where the growth rate of the coupled operator's mode is 0, by the secant method on mu.
double neutral_by_secants(const test::SmallFlow& small, double mu_0, double mu_1, Complex near) {
  const auto growth = [&](double mu) {
    const CoupledOperator coupled = small.coupled(K_B, mu);
    near = eigenpair_near(coupled.assembled(), near).lambda;
    return near.real();
  };
  double g_0 = growth(mu_0), g_1 = growth(mu_1);
  for (int i = 0; i < 12 && std::abs(g_1) > 1e-12; ++i) {
    const double next = mu_1 - g_1 * (mu_1 - mu_0) / (g_1 - g_0);
    mu_0 = std::exchange(mu_1, next);
    g_0 = std::exchange(g_1, growth(mu_1));
  }
  return mu_1;
}

TEST(GlobalNeutralModes, AreWhereTheGrowthRateOfTheCoupledOperatorIsZero) {
  for (const double k_x : {0.0, 2.0}) {
    const test::SmallFlow small(n_theta, k_x);
    const FlagOperator flag = small.flag(K_B);
    AerodynamicMatrix F(small.coupled(K_B).shared_fluid(), umfpack_factors());
    const SampledFit fit =
        sampled_fit([&](Complex lambda) { return F.at(lambda); }, {1, 10}, 1e-5, 60);
    const std::vector<NeutralMode> modes =
        neutral_modes(fit.aerodynamics(), flag, {1, 10}, {0.02, 2});
    ASSERT_FALSE(modes.empty());
    const auto mode = neutral_mode(
        [&](Complex lambda) {
          return Response{F.at(lambda),
                          [&](const Eigen::VectorXcd& zeta) { return F.derivative(zeta); }};
        },
        flag, modes[0].omega, modes[0].mu);
    ASSERT_TRUE(mode);
    EXPECT_LE(mode->evaluations, 3);
    EXPECT_NEAR(modes[0].mu, mode->mu, 1e-3 * mode->mu);  // the fit's error
    const double by_secants =
        neutral_by_secants(small, 0.99 * mode->mu, 1.01 * mode->mu, Complex(0, mode->omega));
    EXPECT_NEAR(mode->mu, by_secants, 1e-8 * mode->mu) << "k_x = " << k_x;
  }
}

TEST(GlobalBaseFlow, FromAFlowNearbyIsThatFromTheUniformStream) {
  const dns::OGrid grid({.n_rho = 12, .n_theta = 24, .R = 3, .wall_spacing = 0.1});
  const PlaneParameters here{.Re = 150, .U = 0.3, .dt_of_pressure = 0.01},
      nearby{.Re = 200, .U = 0.3, .dt_of_pressure = 0.01};
  const BaseFlow far = base_flow(grid, here, 3);
  const BaseFlow near = base_flow(grid, here, 3, base_flow(grid, nearby, 2));
  EXPECT_LT(near.iterations, far.iterations);
  for (int f = 0; f < far.q.fields(); ++f)
    for (std::size_t k = 0; k < far.q.p.values().size(); ++k)
      ASSERT_NEAR(far.q.field(f).values()[k], near.q.field(f).values()[k], 1e-10);
  EXPECT_NEAR(far.drag_coefficient, near.drag_coefficient, 1e-12);
}

}  // namespace
}  // namespace pennon::modes::global

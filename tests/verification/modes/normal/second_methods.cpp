/// The modes in vacuum by methods that share nothing with modes/: collocation, which is told the
/// natural conditions of the free edge; an integral equation; and a Ritz method with exact
/// integrals.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/eigen.hpp>
#include <cmath>
#include <numbers>
#include <vector>

#include "modes/normal/in_vacuo.hpp"

namespace pennon::modes {
namespace {

using Digits50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                               boost::multiprecision::et_off>;
using Digits100 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>,
                                                boost::multiprecision::et_off>;
template <class Scalar>
using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
using Extended = long double;

constexpr int modes = 8;
constexpr double T_0 = 0.0411;

FlagParameters flag_with(double K_B, double k_x, LeadingEdge leading_edge) {
  FlagParameters flag;
  flag.mu = 1;
  flag.K_B = K_B;
  flag.leading_edge = leading_edge;
  if (k_x > 0) flag.gamma = 2 * std::numbers::pi / k_x;
  return flag;
}

std::vector<double> by_splines(TensionProfile profile, double tension, const FlagParameters& flag) {
  const int n = flag.gamma ? 1 : 0;
  return solve(chordwise_problem(profile, n, tension, flag),
               spline_space(profile, 200, n, tension, flag), modes, "modes")
      .lambda;
}

// lambda from the eigenvalues 1/lambda of a compact operator, the largest first.
template <class Solver>
std::vector<double> lowest(const Solver& solver) {
  std::vector<Extended> theta;
  for (Eigen::Index i = 0; i < solver.eigenvalues().size(); ++i)
    theta.push_back(std::real(solver.eigenvalues()[i]));
  std::ranges::sort(theta, std::greater<>());
  std::vector<double> lambda;
  for (std::size_t i = 0; i < modes; ++i) lambda.push_back(static_cast<double>(1 / theta[i]));
  return lambda;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] / b[i] - 1));
  return largest;
}

// Chebyshev's points on [0, 1], from 0 to 1, and the matrix that differentiates at them.
struct Chebyshev {
  Matrix<Digits50> y, D;

  explicit Chebyshev(int intervals) : y(intervals + 1, 1), D(intervals + 1, intervals + 1) {
    const Digits50& pi = boost::math::constants::pi<Digits50>();
    for (int i = 0; i <= intervals; ++i) y(i) = (1 - cos(pi * i / intervals)) / 2;
    const auto weight = [&](int i) {
      return Digits50(i % 2 == 0 ? 1 : -1) / (i == 0 || i == intervals ? 2 : 1);
    };
    for (int i = 0; i <= intervals; ++i) {
      D(i, i) = 0;
      for (int j = 0; j <= intervals; ++j)
        if (j != i) {
          D(i, j) = weight(j) / weight(i) / (y(i) - y(j));
          D(i, i) -= D(i, j);
        }
    }
  }
};

// K_B (Y'''' - 2 k_x^2 Y'' + k_x^4 Y) - T Y'' + nu_s T k_x^2 Y = lambda Y at the inner points, T
// constant; four conditions at the edges give the outer four values.
std::vector<double> by_collocation(const FlagParameters& flag, double k_x, double tension) {
  constexpr int intervals = 44;
  const Chebyshev grid(intervals);
  const Matrix<Digits50> D_2 = grid.D * grid.D;
  const Matrix<Digits50> D_3 = D_2 * grid.D;
  const Matrix<Digits50> one = Matrix<Digits50>::Identity(intervals + 1, intervals + 1);
  const Digits50 K_B = flag.K_B, T = tension, nu_s = flag.nu_s, k_2 = Digits50(k_x) * k_x;
  const Matrix<Digits50> L =
      K_B * (D_2 * D_2 - 2 * k_2 * D_2 + k_2 * k_2 * one) - T * D_2 + nu_s * T * k_2 * one;
  Matrix<Digits50> edges(4, intervals + 1);
  edges.row(0) = one.row(0);
  edges.row(1) =
      flag.leading_edge == LeadingEdge::clamped ? grid.D.row(0) : Matrix<Digits50>(D_2.row(0));
  edges.row(2) = D_2.row(intervals) - nu_s * k_2 * one.row(intervals);
  edges.row(3) = K_B * (D_3.row(intervals) - (2 - nu_s) * k_2 * grid.D.row(intervals)) -
                 T * grid.D.row(intervals);

  const std::vector<int> outer = {0, 1, intervals - 1, intervals};
  std::vector<int> inner;
  for (int i = 2; i < intervals - 1; ++i) inner.push_back(i);
  const Matrix<Digits50> at_outer = edges(Eigen::all, outer);
  const Matrix<Digits50> at_inner = edges(Eigen::all, inner);
  const Matrix<Digits50> outer_of_inner = -at_outer.partialPivLu().solve(at_inner);
  const Matrix<Digits50> reduced = L(inner, inner) + L(inner, outer) * outer_of_inner;
  const Matrix<Digits50> inverse = reduced.partialPivLu().inverse();
  return lowest(Eigen::EigenSolver<Matrix<Extended>>(inverse.cast<Extended>(), false));
}

TEST(InVacuoModes, AgreeWithCollocationThatIsToldTheFreeEdgesConditions) {
  for (const LeadingEdge edge : {LeadingEdge::pinned, LeadingEdge::clamped})
    for (const double k_x : {1.0, 6.283, 30.0})
      for (const double K_B : {1e-2, 1.0}) {
        const FlagParameters flag = flag_with(K_B, k_x, edge);
        EXPECT_LT(difference(by_splines(TensionProfile::constant, T_0, flag),
                             by_collocation(flag, k_x, T_0)),
                  1e-12)
            << "k_x = " << k_x << ", K_B = " << K_B;
      }
}

// Y(y) = the integral of w Y over [0, y] and so on: with y = t^2 and no bending,
// T_0 (1-t) Y_y = lambda * (the integral of Y over [y, 1]) and Y = (the integral of Y_y over [0,
// y]), both taken over the polynomial in t that interpolates at Gauss's points.
std::vector<double> by_integral_equation() {
  constexpr int points = 60;
  // Legendre's polynomials on [-1, 1] and their integrals from -1.
  const auto legendre = [](Extended u, int count) {
    std::vector<Extended> P{1, u};
    for (int k = 1; k < count; ++k) P.push_back(((2 * k + 1) * u * P[k] - k * P[k - 1]) / (k + 1));
    return P;
  };
  // The points are the eigenvalues of Jacobi's matrix (Golub & Welsch 1969).
  Matrix<Extended> jacobi = Matrix<Extended>::Zero(points, points);
  for (int k = 1; k < points; ++k)
    jacobi(k, k - 1) = jacobi(k - 1, k) = k / std::sqrt(4 * Extended(k) * k - 1);
  const Matrix<Extended> u = Eigen::SelfAdjointEigenSolver<Matrix<Extended>>(jacobi).eigenvalues();
  Matrix<Extended> values(points, points), integrals(points, points);
  for (int i = 0; i < points; ++i) {
    const std::vector<Extended> P = legendre(u(i), points + 1);
    for (int k = 0; k < points; ++k) {
      values(i, k) = P[k];
      integrals(i, k) = k == 0 ? u(i) + 1 : (P[k + 1] - P[k - 1]) / (2 * k + 1);
    }
  }
  const Matrix<Extended> from_0 = integrals * values.inverse() / 2;  // over t in [0, 1]
  Matrix<Extended> whole = Matrix<Extended>::Zero(points, points);
  whole.col(0).setConstant(2);
  const Matrix<Extended> to_1 = whole * values.inverse() / 2 - from_0;
  const Eigen::Matrix<Extended, Eigen::Dynamic, 1> t = (u.array() + 1) / 2;
  const Eigen::Matrix<Extended, Eigen::Dynamic, 1> flexibility = 1 / (T_0 * (1 - t.array()));
  const Matrix<Extended> G =
      from_0 * (2 * t).asDiagonal() * flexibility.asDiagonal() * to_1 * (2 * t).asDiagonal();
  return lowest(Eigen::EigenSolver<Matrix<Extended>>(G, false));
}

TEST(InVacuoModes, UnderBlasiusTensionAgreeWithAnIntegralEquation) {
  EXPECT_LT(
      difference(by_splines(TensionProfile::blasius, T_0, flag_with(0, 0, LeadingEdge::pinned)),
                 by_integral_equation()),
      1e-12);
}

// Y = the sum of c_p y^(p/2): what the square root in the tension brings about, with every integral
// of the energy known in closed form. y^(3/2) bends too sharply for a finite energy where K_B > 0.
std::vector<double> by_half_powers(const FlagParameters& flag, double k_x) {
  constexpr int count = 44;
  std::vector<Digits100> powers;
  for (int p = 2; static_cast<int>(powers.size()) < count; ++p) {
    const bool is_too_sharp = p == 3 && flag.K_B > 0;
    const bool turns_at_edge = p == 2 && flag.K_B > 0 && flag.leading_edge == LeadingEdge::clamped;
    if (!is_too_sharp && !turns_at_edge) powers.push_back(Digits100(p) / 2);
  }
  const Digits100 half = Digits100(1) / 2;
  const Digits100 K_B = flag.K_B, nu_s = flag.nu_s, k_2 = Digits100(k_x) * k_x, T = T_0;
  // The integrals of y^e and of y^e (1 - sqrt(y)) times a factor that is 0 where they do not exist.
  const auto plain = [](const Digits100& factor, const Digits100& e) {
    return factor == 0 ? Digits100(0) : Digits100(factor / (e + 1));
  };
  const auto tensed = [&](const Digits100& factor, const Digits100& e) {
    return Digits100(plain(factor, e) - plain(factor, e + half));
  };
  Matrix<Digits100> K(count, count), M(count, count);
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Digits100 a = powers[i], b = powers[j], e = a + b;
      const Digits100 mixed = a * (a - 1) + b * (b - 1);
      K(i, j) = K_B * (plain(a * (a - 1) * b * (b - 1), e - 4) - nu_s * k_2 * plain(mixed, e - 2) +
                       2 * (1 - nu_s) * k_2 * plain(a * b, e - 2) + k_2 * k_2 * plain(1, e)) +
                T * (tensed(a * b, e - 2) + nu_s * k_2 * tensed(1, e));
      M(i, j) = plain(1, e);
    }
  const Matrix<Digits100> C = K.llt().matrixL();
  const Matrix<Digits100> half_way = C.triangularView<Eigen::Lower>().solve(M);
  const Matrix<Digits100> theta =
      C.triangularView<Eigen::Lower>().solve(Matrix<Digits100>(half_way.transpose()));
  return lowest(Eigen::SelfAdjointEigenSolver<Matrix<Extended>>(theta.cast<Extended>()));
}

TEST(InVacuoModes, UnderBlasiusTensionAgreeWithHalfPowersAndExactIntegrals) {
  for (const LeadingEdge edge : {LeadingEdge::pinned, LeadingEdge::clamped})
    for (const double k_x : {0.0, 3.0, 12.0})
      for (const double K_B : {0.0, 1e-3, 1.0}) {
        const FlagParameters flag = flag_with(K_B, k_x, edge);
        EXPECT_LT(
            difference(by_splines(TensionProfile::blasius, T_0, flag), by_half_powers(flag, k_x)),
            1e-12)
            << "k_x = " << k_x << ", K_B = " << K_B;
      }
}

}  // namespace
}  // namespace pennon::modes

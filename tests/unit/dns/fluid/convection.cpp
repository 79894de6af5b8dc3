/// The differences of the convective term: what each does to a wave that alternates between cells,
/// and to the polynomials for which it is exact.
#include "dns/fluid/equations/convection.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace pennon::dns {
namespace {

constexpr Extent cells{1, 8, 8};

template <class Function>
Field<double> field_of(const Function& f) {
  Field<double> field(cells);
  for (int j = -2; j < cells.n_rho + 2; ++j)
    for (int i = -2; i < cells.n_theta + 2; ++i) field.row(0, j)[i] = f(j, i);
  return field;
}

// (C . grad) f at a cell in the middle, C in cells per time across rho and theta.
template <class Function>
double convected(double C_s, double C_t, Convection differences, const Function& f) {
  const Field<double> s = field_of([&](int, int) { return C_s; }),
                      t = field_of([&](int, int) { return C_t; });
  Field<double> result(cells);
  convection(0, s, t, field_of(f), upwinding_of(differences), result);
  return result.row(0, 4)[4];
}

// The fourth difference of (-1)^i is 16: 16/12 times the factor damps it, whatever way C points.
TEST(Convection, DampsWhatAlternatesBetweenCellsByItsFactor) {
  const auto along_s = [](int j, int) { return j % 2 == 0 ? 1.0 : -1.0; };
  const auto along_t = [](int, int i) { return i % 2 == 0 ? 1.0 : -1.0; };
  for (const double C : {1.0, -1.0}) {
    EXPECT_NEAR(convected(C, 0, Convection::kawamura_kuwahara, along_s), 4, 1e-14);
    EXPECT_NEAR(convected(0, C, Convection::kawamura_kuwahara, along_t), 4, 1e-14);
    EXPECT_NEAR(convected(C, 0, Convection::third_order, along_s), 4.0 / 3, 1e-14);
    EXPECT_NEAR(convected(0, C, Convection::third_order, along_t), 4.0 / 3, 1e-14);
    EXPECT_NEAR(convected(C, 0, Convection::central, along_s), 0, 1e-14);
    EXPECT_NEAR(convected(0, C, Convection::central, along_t), 0, 1e-14);
  }
}

TEST(Convection, IsExactForCubicsOrForParabolas) {
  const auto cubic = [](double x) { return 1 + 2 * x - 0.5 * x * x + 0.25 * x * x * x; };
  const double slope = 2 - 0.5 * 2 * 4 + 0.25 * 3 * 16;  // at 4
  for (const Convection differences : {Convection::kawamura_kuwahara, Convection::third_order})
    for (const double C : {0.7, -1.3}) {
      EXPECT_NEAR(convected(C, 0, differences, [&](int j, int) { return cubic(j); }), C * slope,
                  1e-12);
      EXPECT_NEAR(convected(0, C, differences, [&](int, int i) { return cubic(i); }), C * slope,
                  1e-12);
    }
  const auto parabola = [](double x) { return 1 + 2 * x - 0.5 * x * x; };
  EXPECT_NEAR(convected(0.7, 0, Convection::central, [&](int j, int) { return parabola(j); }),
              0.7 * (2 - 4), 1e-12);
}

}  // namespace
}  // namespace pennon::dns

/// The zeros of the Bessel functions J_n, against 50 digits and against their own properties.
#include "modes/normal/bessel_zero.hpp"

#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <vector>

#include "common/errors.hpp"

namespace pennon::modes {
namespace {

using Exact = boost::multiprecision::cpp_bin_float_50;

// Half a unit of the last place is at most 1.1e-16 of the number; Newton's last step adds a little.
constexpr double half_unit = 1.5e-16;

double relative_error(double found, const Exact& exact) {
  return static_cast<double>(abs(Exact(found) / exact - 1));
}

TEST(BesselZero, AgreesWithFiftyDigits) {
  for (const int n : {0, 1, 2, 3, 5, 19, 20, 50, 99, 137, 200})
    for (const int m : {1, 2, 4, 5, 6, 10, 37, 100, 500, 1000})
      EXPECT_LE(relative_error(bessel_zero(n, m), boost::math::cyl_bessel_j_zero(Exact(n), m)),
                half_unit)
          << "n = " << n << ", m = " << m;
}

TEST(BesselZero, IsWhereGslIsLeastAccurate) {
  for (int n = 0; n <= largest_n; ++n)
    EXPECT_LE(
        relative_error(bessel_zero(n, 5), Exact(boost::math::cyl_bessel_j_zero<long double>(n, 5))),
        half_unit)
        << "n = " << n;
}

TEST(BesselZero, LiesBetweenItsNeighboursOfTheNextOrder) {
  // alpha_nm < alpha_n+1,m < alpha_n,m+1
  for (int n = 0; n < largest_n; n += 7)
    for (int m = 1; m < largest_m; m += 3) {
      const double next = bessel_zero(n + 1, m);
      ASSERT_LT(bessel_zero(n, m), next) << "n = " << n << ", m = " << m;
      ASSERT_LT(next, bessel_zero(n, m + 1)) << "n = " << n << ", m = " << m;
    }
}

TEST(BesselZero, GrowsWithItsRankByMoreThanPiForPositiveOrders) {
  // The spacing falls to pi from above for n >= 1 and rises to it from below for n = 0.
  for (const int n : {1, 2, 20, 200}) {
    double before = bessel_zero(n, 1);
    for (int m = 2; m <= largest_m; ++m) {
      const double zero = bessel_zero(n, m);
      ASSERT_GT(zero - before, boost::math::constants::pi<double>())
          << "n = " << n << ", m = " << m;
      before = zero;
    }
  }
}

TEST(BesselZero, OutsideItsRangeIsRefusedWithTheRange) {
  for (const auto& [n, m] : std::vector<std::pair<int, int>>{{-1, 1}, {201, 1}, {0, 0}, {3, 1001}})
    EXPECT_THROW(bessel_zero(n, m), InputError) << "n = " << n << ", m = " << m;
  try {
    bessel_zero(0, 0);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("m must be 1 to 1000"), std::string::npos)
        << error.what();
  }
}

TEST(BesselFunction, AgreesWithFiftyDigitsAndUnderflowsToZero) {
  constexpr double few_units_of_one = 1e-15;
  for (const int n : {0, 1, 2, 7, 50, 200})
    for (const double x : {0.0, 1e-3, 0.5, 3.0, 40.0, 199.0, 205.0, 1000.0, 3450.0})
      EXPECT_NEAR(bessel_j(n, x), static_cast<double>(boost::math::cyl_bessel_j(n, Exact(x))),
                  few_units_of_one)
          << "n = " << n << ", x = " << x;
  EXPECT_EQ(bessel_j(200, 1e-3), 0);
}

}  // namespace
}  // namespace pennon::modes

// The Fourier series along the span.
#include "dns/grid/span.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace pennon::dns {
namespace {

constexpr double length = 1.7;

// 10 and 9 planes go by matrices, 150 and 151 by fast transforms.
class SpanOfPlanes : public testing::TestWithParam<int> {
 protected:
  Field<double> sampled(double (*f)(double)) const {
    Field<double> field(extent_);
    for (int m = 0; m < GetParam(); ++m)
      for (int i = 0; i < extent_.n_theta; ++i)
        field.row(m, 0)[i] = (1 + i) * f(2 * std::numbers::pi * m / GetParam());
    return field;
  }
  Extent extent_{GetParam(), 1, 3};
  Span span_{GetParam(), length};
};

TEST_P(SpanOfPlanes, DifferentiatesWavesExactly) {
  const Field<double> f =
      sampled([](double x) { return 2 + std::cos(x) - 3 * std::sin(2 * x) + std::cos(3 * x); });
  const Field<double> expected = sampled([](double x) {
    return 2 * std::numbers::pi / length *
           (-std::sin(x) - 6 * std::cos(2 * x) - 3 * std::sin(3 * x));
  });
  Field<double> f_x(extent_);
  span_.differentiate(f, f_x);
  for (int m = 0; m < GetParam(); ++m)
    for (int i = 0; i < extent_.n_theta; ++i)
      EXPECT_NEAR(f_x.row(m, 0)[i], expected.row(m, 0)[i], 1e-11);
}

TEST_P(SpanOfPlanes, TakesValuesToCoefficientsAndBack) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> values(static_cast<std::size_t>(GetParam()) * 7);
  for (double& value : values) value = normal(random);
  std::vector<double> changed = values;
  span_.to_coefficients(changed.data(), 7, 7);
  span_.to_values(changed.data(), 7, 7);
  for (std::size_t k = 0; k < values.size(); ++k) EXPECT_NEAR(changed[k], values[k], 1e-13);
}

TEST_P(SpanOfPlanes, KeepsCosineAndSineOfAWaveInItsTwoPlanes) {
  const double phase = 0.3;
  std::vector<double> values(static_cast<std::size_t>(GetParam()));
  for (int m = 0; m < GetParam(); ++m)
    values[static_cast<std::size_t>(m)] =
        2 * std::cos(2 * 2 * std::numbers::pi * m / GetParam() + phase);
  span_.to_coefficients(values.data(), 1, 1);
  for (int c = 0; c < GetParam(); ++c) {
    const double expected = c == 2 ? std::cos(phase) : c == GetParam() - 2 ? std::sin(phase) : 0.0;
    EXPECT_NEAR(values[static_cast<std::size_t>(c)], expected, 1e-14) << c;
    EXPECT_EQ(span_.waves(c), std::min(c, GetParam() - c));
  }
}

TEST_P(SpanOfPlanes, DealiasingTakesOutTheUpperThirdAndNothingElse) {
  std::vector<double> values(static_cast<std::size_t>(GetParam()));
  for (int waves = 0; 2 * waves <= GetParam(); ++waves) {
    for (int m = 0; m < GetParam(); ++m)
      values[static_cast<std::size_t>(m)] =
          std::cos(2 * std::numbers::pi * (waves * m % GetParam()) / GetParam());
    const std::vector<double> before = values;
    span_.dealias(values.data(), 1, 1);
    const double share = 3 * waves < GetParam() ? 1 : 0;
    for (std::size_t m = 0; m < values.size(); ++m)
      EXPECT_NEAR(values[m], share * before[m], 1e-13) << waves;
  }
}

TEST_P(SpanOfPlanes, TheHighestWaveOfAnEvenNumberIsGivenNoDerivative) {
  if (GetParam() % 2 != 0) return;
  Field<double> f(extent_), f_x(extent_);
  for (int m = 0; m < GetParam(); ++m) f.row(m, 0)[0] = m % 2 == 0 ? 1 : -1;
  span_.differentiate(f, f_x);
  for (int m = 0; m < GetParam(); ++m) EXPECT_NEAR(f_x.row(m, 0)[0], 0, 1e-12);
  EXPECT_TRUE(span_.is_dropped(GetParam() / 2));
}

INSTANTIATE_TEST_SUITE_P(Few, SpanOfPlanes, testing::Values(8, 9, 24));
INSTANTIATE_TEST_SUITE_P(Many, SpanOfPlanes, testing::Values(150, 151));

TEST(Span, OfOnePlaneIsTwoDimensional) {
  const Span span(1, 1);
  EXPECT_FALSE(span.has_span());
  EXPECT_EQ(Span::wavenumber(0, 1, 1), 0);
}

}  // namespace
}  // namespace pennon::dns

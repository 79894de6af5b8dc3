#include "analysis/decomposition/projection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"
#include "common/io/hdf5.hpp"
#include "modes/normal/bessel.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/held_snapshots.hpp"
#include "tests/support/temporary_folder.hpp"

namespace pennon::decomposition {
namespace {

using namespace pennon::test;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using testing::HasSubstr;

// The shapes of a flag at nodes y, at stations along a span or in two dimensions.
class FlagShapes final : public Snapshots {
 public:
  static constexpr double span = 2;

  FlagShapes(std::size_t stations, const std::vector<double>& y, std::vector<double> t,
             const std::function<double(double x, double y, double t)>& z)
      : Snapshots(layout_of(stations, y, std::move(t))),
        z_(static_cast<Index>(layout().points), static_cast<Index>(layout().t.size())) {
    for (Index i = 0; i < z_.rows(); ++i)
      for (Index m = 0; m < z_.cols(); ++m) {
        const auto point = static_cast<std::size_t>(i);
        const std::size_t station = point / y.size();
        const double x = span * static_cast<double>(station) / static_cast<double>(stations);
        z_(i, m) = z(x, layout().y[point], layout().t[static_cast<std::size_t>(m)]);
      }
  }
  void read(Band band, MatrixXd& values) const override {
    values = z_.middleRows(static_cast<Index>(band.first), static_cast<Index>(band.count));
  }
  MatrixXd weights(Band band) const override {
    return MatrixXd::Constant(static_cast<Index>(band.count), 1, 0.3);
  }

 private:
  static Layout layout_of(std::size_t stations, const std::vector<double>& y,
                          std::vector<double> t) {
    Layout layout{.name = "test",
                  .quantity = "z",
                  .t = std::move(t),
                  .points = stations * y.size(),
                  .components = {"z"}};
    if (stations > 1) layout.stations = Stations{span, stations};
    for (std::size_t i = 0; i < stations; ++i) layout.y.insert(layout.y.end(), y.begin(), y.end());
    return layout;
  }
  MatrixXd z_;
};

std::vector<double> nodes(Index count) {
  return steps(count, 1.0 / static_cast<double>(count - 1));
}

Bands<double> bands_of(const Snapshots& shapes) {
  return {shapes, {.removes_mean = false}};
}

TEST(Projection, FindsTheAmplitudesOfNormalModesAgain) {
  FlagParameters flag;
  flag.mu = 0.1;
  flag.gamma = FlagShapes::span;
  FlowParameters flow;
  flow.Re = 1000;
  const auto modes = given_modes(modes::bessel_modes({.n = {0, 1, 2}, .m = 3}, flag, flow));
  ASSERT_EQ(modes.size(), 9U);
  const MatrixXcd a = NormalNumbers(1).complex_matrix(9, 20);
  const FlagShapes shapes(8, nodes(25), steps(20, 0.1), [&](double x, double y, double t) {
    double z = 0;
    for (Index j = 0; j < 9; ++j) {
      const GivenMode& mode = modes[static_cast<std::size_t>(j)];
      z += (a(j, std::lround(t / 0.1)) * mode.Y(y) * std::polar(1.0, mode.k * x)).real();
    }
    return z;
  });
  const Projection found = project(bands_of(shapes), modes);
  EXPECT_LT(found.error(), 1e-12);
  for (Index j = 0; j < 9; ++j)
    for (Index m = 0; m < 20; ++m) {
      // Of what does not vary along the span the imaginary part moves nothing.
      const bool stands = modes[static_cast<std::size_t>(j)].is_standing;
      const Complex expected = stands ? Complex(a(j, m).real()) : a(j, m);
      EXPECT_LT(std::abs(found.a(j, m) - expected), 1e-10) << j << " " << m;
    }
}

// Two waves of the flag's global modes grow side by side, each as its eigenvalue says.
TEST(Projection, TellsTheGrowthOfTwoGlobalModesAtOnce) {
  const TemporaryFolder folder;
  const Complex lambda[] = {{0.3, 2.6}, {-0.4, 4.7}};
  const std::vector<double> y = nodes(33);
  const auto shape = [](int mode, double at) {
    return at * std::polar(1.0, (mode + 2) * at) * (1 + 0.3 * mode * at);
  };
  {
    hdf5::Writer file(folder / "global_modes.h5");
    file.attributes({{"kind", "global_modes"}, {"k_x", 0.0}});
    file.write("/growth", {3}, std::vector<double>{0.3, -0.4, 0.1});
    file.write("/omega", {3}, std::vector<double>{2.6, 4.7, 0});
    file.write("/is_box", {3}, std::vector<double>{0, 0, 1});
    file.write("/y", {y.size()}, y);
    for (int mode = 0; mode < 3; ++mode) {
      std::vector<double> real, imaginary;
      for (const double at : y) {
        real.push_back(shape(mode, at).real());
        imaginary.push_back(shape(mode, at).imag());
      }
      const std::string group = "/mode_" + std::to_string(mode + 1);
      file.write(group + "/zeta_real", {y.size()}, real);
      file.write(group + "/zeta_imag", {y.size()}, imaginary);
    }
    file.finish();
  }
  const FlagShapes shapes(1, y, steps(60, 0.05), [&](double, double at, double t) {
    return 1e-4 *
           (std::exp(lambda[0] * t) * shape(0, at) + 0.2 * std::exp(lambda[1] * t) * shape(1, at))
               .real();
  });
  const auto modes = given_global_modes(folder / "global_modes.h5", {});
  ASSERT_EQ(modes.size(), 2U) << "without that of the box";
  const Projection found = project(bands_of(shapes), modes);
  EXPECT_LT(found.error(), 1e-10);
  for (Index j = 0; j < 2; ++j) {
    const Slopes slopes = slopes_of(shapes.layout().t, found.a.row(j));
    EXPECT_NEAR(slopes.growth, lambda[j].real(), 1e-9);
    EXPECT_NEAR(slopes.omega, lambda[j].imag(), 1e-9);
    EXPECT_LT(slopes.growth_error + slopes.omega_error, 1e-9);
  }
  EXPECT_THAT(failure_of<InputError>([&] { given_global_modes(folder / "global_modes.h5", 4); }),
              HasSubstr("holds 3 modes; decompose.n_modes = 4"));
}

TEST(Projection, SaysWhatIsLeft) {
  const GivenMode straight{"straight", 0, {}, [](double y) { return Complex(y); }, true};
  const FlagShapes shapes(1, nodes(50), steps(4, 1),
                          [](double, double y, double) { return y * y; });
  const Projection found = project(bands_of(shapes), {straight});
  // Of y^2 on y: a = 3/4, and what is left has (1/5 - 9/48)^(1/2) of (1/5)^(1/2), but for the sums.
  EXPECT_NEAR(found.a(0, 0).real(), 0.75, 0.02);
  EXPECT_NEAR(found.error(), std::sqrt((0.2 - 9.0 / 48) / 0.2), 0.02);
}

TEST(Projection, RefusesWhatTheNodesDoNotTellApart) {
  const auto mode = [](double k) {
    return GivenMode{"a mode", k, {}, [](double y) { return Complex(y); }, k == 0};
  };
  const auto fault = [&](std::size_t stations, const std::vector<GivenMode>& modes) {
    const FlagShapes shapes(stations, nodes(9), steps(4, 1),
                            [](double, double y, double) { return y; });
    return failure_of<InputError>([&] { project(bands_of(shapes), modes); });
  };
  EXPECT_THAT(fault(1, {mode(0), mode(0)}), HasSubstr("9 nodes do not tell 2 modes apart"));
  EXPECT_THAT(fault(1, {mode(3)}),
              HasSubstr("a mode has k_x = 3, and the shapes in test have no span"));
  EXPECT_THAT(fault(8, {mode(3)}), HasSubstr("has 0.95493 waves (k_x = 3) in the span 2"));
  EXPECT_THAT(fault(8, {mode(4 * std::numbers::pi)}), HasSubstr("which 8 stations do not resolve"));
}

}  // namespace
}  // namespace pennon::decomposition

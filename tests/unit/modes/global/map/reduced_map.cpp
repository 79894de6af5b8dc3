// Maps of growth rates in a basis of few shapes, on a small grid: against the whole operator.
#include <gtest/gtest.h>
#include <omp.h>

#include <random>

#include "common/errors.hpp"
#include "modes/global/map/check_places.hpp"
#include "modes/global/map/flag_basis.hpp"
#include "modes/global/map/reduced_map.hpp"
#include "modes/global/solve/aerodynamic_matrix.hpp"
#include "modes/global/solve/spectrum.hpp"
#include "modes/global/study/growth_map.hpp"
#include "tests/support/small_flag_flow.hpp"

namespace pennon::modes::global {
namespace {

using Complex = std::complex<double>;

constexpr int n_theta = 48;
constexpr double tolerance = 1e-5;  // of lambda

struct SmallMap {
  test::SmallFlow small;
  std::vector<double> K_B = {0, 1e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2}, mu;
  ReducedMapSettings wanted{.windows = {{1, 10}},
                            .mu_of_modes = {1e-3, 20},
                            .fit_tolerance = 1e-5,
                            .lambda_tolerance = tolerance,
                            .checks = 4};

  explicit SmallMap(double k_x = 0, double U = 0) : small(n_theta, k_x, U) {
    for (int m = 0; m < 16; ++m) mu.push_back(0.05 * std::pow(20, m / 15.0));
  }
  std::vector<FlagOperator> flags() const {
    std::vector<FlagOperator> all;
    for (const double stiffness : K_B) all.push_back(small.flag(stiffness));
    return all;
  }
  ReducedMap find() const {
    const CoupledOperator coupled = small.coupled(K_B[0]);
    AerodynamicMatrix F(coupled.shared_fluid(), umfpack_factors());
    return find([&](Complex lambda) { return F.at(lambda); });
  }
  ReducedMap find(const SampleOf& F) const { return reduced_map(F, flags(), mu, wanted); }
  // |lambda of the map - that of the whole operator|.
  double error(const ReducedMap& map, std::size_t column, std::size_t m) const {
    const Complex lambda = map.columns[column].leading[m]->mode.lambda;
    const CoupledOperator coupled = small.coupled(K_B[column], mu[m]);
    return std::abs(eigenpair_near(coupled.assembled(), lambda).lambda - lambda);
  }
};

TEST(GlobalFlagBasis, OfAllShapesLeavesTheFlagAsItIs) {
  const test::SmallFlow small(n_theta);
  const FlagOperator flag = small.flag(1e-3);
  const Eigen::Index n = flag.mass.size();
  FlagBasis basis(flag.mass, {Eigen::VectorXcd::Ones(n)}, 1e-8);
  for (Eigen::Index k = 0; k < 2 * n; ++k) basis.add(Eigen::VectorXcd::Random(n));
  ASSERT_EQ(basis.size(), n);
  const Eigen::VectorXcd a = Eigen::VectorXcd::Random(n), zeta = basis.shape(a);
  const Eigen::VectorXd ones = basis.reduced(flag).mass;
  EXPECT_NEAR(std::abs(zeta.dot(flag.mass.cwiseProduct(zeta))), a.squaredNorm(), 1e-10);
  EXPECT_EQ(ones, Eigen::VectorXd::Ones(n));
  const Eigen::MatrixXcd F = Eigen::MatrixXcd::Random(n, n);
  const Eigen::VectorXcd whole = mass_ratios(F, flag, 2),
                         small_ones = mass_ratios(basis.reduced(F), basis.reduced(flag), 2);
  for (const Complex ratio : whole)
    EXPECT_LT((small_ones.array() - ratio).abs().minCoeff(), 1e-9 * whole.cwiseAbs().maxCoeff());
}

TEST(GlobalRationalFit, InABasisIsTheProjectionOfItsValuesAndSlopes) {
  std::vector<MatrixSample> samples;
  samples.reserve(8);
  const Eigen::MatrixXcd A = Eigen::MatrixXcd::Random(6, 6), B = Eigen::MatrixXcd::Random(6, 6);
  for (int i = 0; i < 8; ++i)
    samples.push_back({Complex(0, i), A / Complex(1, i) + B * Complex(0, i)});
  const RationalFit fit(samples, 1e-12);
  const Eigen::MatrixXcd basis = Eigen::MatrixXcd::Random(6, 3);
  const RationalFit small = fit.projected(basis);
  const Eigen::VectorXcd x = Eigen::VectorXcd::Random(3);
  for (const Complex s : {Complex(0, 3), Complex(0.4, 2.2)}) {
    EXPECT_LT((small(s) - basis.adjoint() * fit(s) * basis).norm(), 1e-12 * fit(s).norm());
    EXPECT_LT((small.derivative(s, x) - basis.adjoint() * fit.derivative(s, basis * x)).norm(),
              1e-12 * fit(s).norm());
  }
}

TEST(EvenlyChosen, HasBothEndsAndEqualSteps) {
  EXPECT_EQ(evenly_chosen(13, 4), (std::vector<std::size_t>{0, 4, 8, 12}));
  EXPECT_EQ(evenly_chosen(3, 8), (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_EQ(evenly_chosen(1, 3), (std::vector<std::size_t>{0}));
  EXPECT_TRUE(evenly_chosen(0, 3).empty());
}

TEST(GlobalReducedMap, FailsWhereTheFitWouldNeedMoreSamplesThanItMayTake) {
  SmallMap small;
  small.wanted.heuristics.most_samples = 10;
  EXPECT_THROW(small.find(), SolverError);
}

TEST(GlobalReducedMap, HasTheModesOfTheWholeOperatorAtItsEndsAndAtRandomPoints) {
  const SmallMap small;
  const ReducedMap map = small.find();
  EXPECT_LE(map.basis_size, small.flags()[0].mass.size());
  EXPECT_LE(map.lambda_error, tolerance);
  EXPECT_GE(map.checked, 4u);
  EXPECT_LE(map.basis_error, tolerance);
  const std::size_t last = small.K_B.size() - 1, top = small.mu.size() - 1;
  std::vector<std::pair<std::size_t, std::size_t>> points = {
      {0, 0}, {0, top}, {last, 0}, {last, top}};
  std::mt19937 random(1);
  for (int k = 0; k < 24; ++k) points.emplace_back(random() % (last + 1), random() % (top + 1));
  std::size_t asked = 0;
  for (const auto& [column, m] : points) {
    if (!map.columns[column].leading[m]) continue;
    ++asked;
    // Twice: what is checked is a part of the points.
    EXPECT_LT(small.error(map, column, m), 2 * tolerance)
        << "K_B = " << small.K_B[column] << ", mu = " << small.mu[m];
  }
  EXPECT_GT(asked, 20u);
}

TEST(GlobalReducedMap, NeedsFewShapesWhereTheStiffnessVariesLittle) {
  SmallMap small;
  small.K_B = {1e-3, 1.5e-3, 2e-3};
  const ReducedMap map = small.find();
  EXPECT_LT(map.basis_size, small.flags()[0].mass.size() * 3 / 4);
  EXPECT_LE(map.basis_error, tolerance);
  for (std::size_t column = 0; column < small.K_B.size(); ++column)
    for (std::size_t m = 1; m < small.mu.size(); m += 7)
      if (map.columns[column].leading[m]) {
        EXPECT_LT(small.error(map, column, m), 2 * tolerance) << small.mu[m];
      }
}

TEST(GlobalReducedMap, IsTheSameForAnyNumberOfThreads) {
  const SmallMap small;
  const CoupledOperator coupled = small.small.coupled(small.K_B[0]);
  AerodynamicMatrix F(coupled.shared_fluid(), umfpack_factors());
  // The response is asked once for each lambda: its last bits depend on where its factors lie.
  std::vector<MatrixSample> known;
  const auto response = [&](Complex lambda) -> Eigen::MatrixXcd {
    for (const MatrixSample& sample : known)
      if (sample.lambda == lambda) return sample.F;
    return known.emplace_back(MatrixSample{lambda, F.at(lambda)}).F;
  };
  std::vector<ReducedMap> maps;
  const int usual = omp_get_max_threads();
  for (const int threads : {1, 2, 3}) {
    omp_set_num_threads(threads);
    maps.push_back(small.find(response));
  }
  omp_set_num_threads(usual);
  for (const ReducedMap& other : maps)
    for (std::size_t column = 0; column < small.K_B.size(); ++column) {
      const std::vector<ColumnNeutral>&one = maps[0].columns[column].neutral,
            &two = other.columns[column].neutral;
      ASSERT_EQ(one.size(), two.size());
      for (std::size_t k = 0; k < one.size(); ++k) EXPECT_EQ(one[k].mu, two[k].mu);
      for (std::size_t m = 0; m < small.mu.size(); ++m) {
        const auto &leading = maps[0].columns[column].leading[m],
                   &same = other.columns[column].leading[m];
        ASSERT_EQ(leading.has_value(), same.has_value());
        if (leading) {
          EXPECT_EQ(leading->mode.lambda, same->mode.lambda);
        }
      }
    }
}

TEST(GlobalReducedMap, NoticesABasisThatIsTooSmallAndMendsIt) {
  SmallMap small;
  small.wanted.basis_tolerance = 0.3;
  small.wanted.is_improved = false;
  const ReducedMap poor = small.find();
  EXPECT_GT(poor.basis_error, tolerance);
  EXPECT_GT(poor.lambda_error, tolerance);
  small.wanted.is_improved = true;
  const ReducedMap mended = small.find();
  EXPECT_GT(mended.basis_size, poor.basis_size);
  EXPECT_LE(mended.basis_error, tolerance);
  EXPECT_LE(mended.lambda_error, tolerance);
}

TEST(GlobalReducedMap, TakesSamplesOffTheAxisWhereAFitAlongItIsPoor) {
  SmallMap small;
  small.wanted.fit_tolerance = 1e-3;
  small.wanted.is_improved = false;
  const ReducedMap poor = small.find();
  EXPECT_GT(poor.lambda_error, tolerance);
  EXPECT_EQ(poor.samples_off_axis, 0u);
  small.wanted.is_improved = true;
  const ReducedMap mended = small.find();
  EXPECT_GT(mended.samples_off_axis, 0u);
  EXPECT_LE(mended.lambda_error, tolerance);
  for (std::size_t column = 0; column < small.K_B.size(); ++column)
    for (const std::size_t m : {std::size_t{3}, small.mu.size() - 1})
      if (mended.columns[column].leading[m]) {
        EXPECT_LT(small.error(mended, column, m), 2 * tolerance);
      }
}

}  // namespace
}  // namespace pennon::modes::global

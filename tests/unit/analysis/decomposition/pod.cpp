#include "analysis/decomposition/pod.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "analysis/decomposition/combined_modes.hpp"
#include "analysis/decomposition/triangular_factor.hpp"
#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/held_snapshots.hpp"

namespace pennon::decomposition {
namespace {

using namespace pennon::test;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using std::numbers::pi;

// Modes orthonormal in a norm of weights: random ones, by Gram and Schmidt.
template <class Scalar>
DenseMatrix<Scalar> orthonormal(DenseMatrix<Scalar> random, const VectorXd& weight) {
  const VectorXd root = weight.cwiseSqrt();
  random = root.asDiagonal() * random;
  const Eigen::HouseholderQR<DenseMatrix<Scalar>> factors(random);
  const DenseMatrix<Scalar> Q =
      factors.householderQ() * DenseMatrix<Scalar>::Identity(random.rows(), random.cols());
  return root.cwiseInverse().asDiagonal() * Q;
}

// Waves in time that are orthogonal over the snapshots and have no mean: cos(2 pi k m/M), times
// 2^1/2, so that their mean squares are 1.
MatrixXd orthogonal_waves(Index count, Index M) {
  return MatrixXd::NullaryExpr(count, M, [&](Index k, Index m) {
    return std::sqrt(2.0) *
           std::cos(2 * pi * static_cast<double>((k + 1) * m) / static_cast<double>(M));
  });
}

const VectorXd energies = VectorXd{{4.0, 1.0, 0.25, 1e-3}};

struct KnownModes {
  MatrixXd phi, a;
  VectorXd weight;

  KnownModes(Index values, Index M) {
    NormalNumbers random(1);
    weight = random.matrix(values, 1).cwiseAbs() + VectorXd::Constant(values, 0.1);
    phi = orthonormal<double>(random.matrix(values, energies.size()), weight);
    a = energies.cwiseSqrt().asDiagonal() * orthogonal_waves(energies.size(), M);
  }
  HeldSnapshots<double> snapshots() const { return {steps(a.cols(), 0.1), phi * a, weight}; }
};

template <class Scalar>
DenseMatrix<Scalar> modes_of(const Bands<Scalar>& bands, const Pod<Scalar>& pod) {
  DenseMatrix<Scalar> phi(static_cast<Index>(bands.layout().values()), pod.combination.cols());
  for_each_band_of_modes<Scalar, Scalar>(
      bands, pod.combination, [&](const BandOfData<Scalar>& data, const DenseMatrix<Scalar>& part) {
        phi.middleRows(static_cast<Index>(data.band.first), part.rows()) = part;
      });
  return phi;
}

void expect_known(Index values, Index M, double memory) {
  const KnownModes known(values, M);
  const auto snapshots = known.snapshots();
  const Bands<double> bands(snapshots, {.memory = memory});
  const Pod<double> found = pod(triangular_factor(bands), true, 4);
  // Roundoff of the largest energy times the root of the ratio.
  for (Index j = 0; j < 4; ++j) EXPECT_NEAR(found.energy(j) / energies(j), 1, 1e-12) << j;
  EXPECT_NEAR(found.variance, energies.sum(), 1e-12 * energies.sum());
  EXPECT_LT(found.energy.tail(found.energy.size() - 4).sum(), 1e-25);
  const MatrixXd phi = modes_of(bands, found);
  const MatrixXd products = phi.transpose() * known.weight.asDiagonal() * phi;
  EXPECT_LT((products - MatrixXd::Identity(4, 4)).norm(), 1e-11);
  for (Index j = 0; j < 4; ++j)
    EXPECT_NEAR(std::abs(phi.col(j).dot(known.weight.cwiseProduct(known.phi.col(j)))), 1, 1e-11)
        << j;
  EXPECT_LT((phi * found.coefficients - known.phi * known.a).norm(), 1e-11)
      << "the sum is the data";
}

TEST(Pod, FindsKnownModesWithMoreValuesThanSnapshots) {
  expect_known(500, 64, 1e9);
}

TEST(Pod, FindsKnownModesWithFewerValuesThanSnapshots) {
  expect_known(20, 300, 1e9);
}

TEST(Pod, FindsTheSameBandByBand) {
  // Three factors of 64 x 64 and a few values at a time.
  expect_known(500, 64, 3 * 64 * 64 * 8 + 7 * 3 * 64 * 8);
}

TEST(Pod, HasCoefficientsWithoutCorrelation) {
  NormalNumbers random(2);
  const HeldSnapshots<double> snapshots(steps(50, 1), random.matrix(80, 50));
  const Bands<double> bands(snapshots, {});
  const Pod<double> found = pod(triangular_factor(bands), true, 10);
  const MatrixXd correlations = found.coefficients * found.coefficients.transpose() / 50;
  EXPECT_LT((correlations - MatrixXd(found.energy.head(10).asDiagonal())).norm(), 1e-12);
  EXPECT_EQ(found.energy.size(), 49) << "the mean takes one";
}

TEST(Pod, FindsModesOfComplexData) {
  NormalNumbers random(3);
  constexpr Index M = 40;
  const MatrixXcd phi = orthonormal<Complex>(random.complex_matrix(60, 2), VectorXd::Ones(60));
  MatrixXcd a(2, M);
  for (Index m = 0; m < M; ++m) {
    const double turn = 2 * pi * static_cast<double>(m) / M;
    a.col(m) << 3.0 * std::polar(1.0, turn), std::polar(1.0, -5 * turn);
  }
  const HeldSnapshots<Complex> snapshots(steps(M, 1), phi * a);
  const Bands<Complex> bands(snapshots, {});
  const Pod<Complex> found = pod(triangular_factor(bands), true, 2);
  EXPECT_NEAR(found.energy(0), 9, 1e-12);
  EXPECT_NEAR(found.energy(1), 1, 1e-12);
  const MatrixXcd modes = modes_of(bands, found);
  EXPECT_LT((modes * found.coefficients - phi * a).norm(), 1e-12);
}

// The wave stands in a frame whose cells change their sizes: the energy counts the cells' sizes at
// each time.
TEST(Pod, WeighsEachSnapshotByTheCellsOfItsTime) {
  NormalNumbers random(4);
  const MatrixXd q = random.matrix(30, 12);
  const MatrixXd weight = random.matrix(30, 12).cwiseAbs();
  const HeldSnapshots<double> snapshots(steps(12, 1), q, weight);
  const Bands<double> bands(snapshots, {.removes_mean = false});
  const Pod<double> found = pod(triangular_factor(bands), false, 12);
  EXPECT_NEAR(found.variance, weight.cwiseProduct(q.cwiseAbs2()).sum() / 12, 1e-12);
  const MatrixXd modes = modes_of(bands, found);
  const VectorXd root = weight.rowwise().mean().cwiseSqrt();
  const MatrixXd weighted = weight.cwiseSqrt().cwiseProduct(q);
  EXPECT_LT((root.asDiagonal() * modes * found.coefficients - weighted).norm(), 1e-12);
}

TEST(Pod, KeepsSmallEnergiesDownToRoundoffOfTheLargestAmplitude) {
  constexpr Index M = 32;
  const MatrixXd phi = orthonormal<double>(NormalNumbers(5).matrix(100, 2), VectorXd::Ones(100));
  MatrixXd a = orthogonal_waves(2, M);
  a.row(1) *= 1e-9;  // an energy of 1e-18, far below roundoff of the largest energy
  const HeldSnapshots<double> snapshots(steps(M, 1), phi * a);
  const Bands<double> bands(snapshots, {});
  const Pod<double> found = pod(triangular_factor(bands), true, 2);
  EXPECT_NEAR(found.energy(1) / 1e-18, 1, 1e-5);
}

TEST(Pod, RefusesDataThatDoNotVary) {
  const HeldSnapshots<double> snapshots(steps(5, 1), MatrixXd::Constant(4, 5, 3.0));
  const Bands<double> bands(snapshots, {});
  EXPECT_THAT(failure_of<InputError>([&] { pod(triangular_factor(bands), true, 1); }),
              testing::HasSubstr("all snapshots are equal"));
}

// A tenth is no number of the machine, and its mean is another one.
TEST(Pod, TakesWhatIsLeftOfAConstantForRounding) {
  const HeldSnapshots<double> snapshots(steps(7, 1), MatrixXd::Constant(4, 7, 0.1));
  const Bands<double> bands(snapshots, {});
  EXPECT_THAT(failure_of<InputError>([&] { pod(triangular_factor(bands), true, 1); }),
              testing::HasSubstr("all snapshots are equal"));
}

TEST(Bands, TakeTheMeanOfWeightsWhereSnapshotsAreCompared) {
  const MatrixXd q = NormalNumbers(6).matrix(5, 8),
                 weight = NormalNumbers(7).matrix(5, 8).cwiseAbs();
  const HeldSnapshots<double> snapshots(steps(8, 1), q, weight);
  const Bands<double> bands(snapshots, {.removes_mean = false, .has_mean_weight = true});
  bands.for_each(0, 0, [&](const BandOfData<double>& data) {
    const VectorXd root = weight.rowwise().mean().cwiseSqrt();
    EXPECT_LT((data.A - root.asDiagonal() * q).norm(), 1e-14);
    EXPECT_LT((data.mean - q.rowwise().mean()).norm(), 1e-15);
  });
}

TEST(Bands, RefuseNumbersWithoutSquares) {
  const HeldSnapshots<double> snapshots(steps(4, 1), MatrixXd::Constant(3, 4, 1e200));
  const Bands<double> bands(snapshots, {});
  EXPECT_THAT(failure_of<InputError>([&] { triangular_factor(bands); }),
              testing::HasSubstr("whose squares are no numbers"));
}

TEST(Bands, RefuseAMemoryThatHoldsNotOneValue) {
  const HeldSnapshots<double> snapshots(steps(100, 1), MatrixXd::Ones(4, 100));
  const Bands<double> bands(snapshots, {.memory = 1000});
  EXPECT_THAT(failure_of<InputError>([&] { triangular_factor(bands); }),
              testing::HasSubstr("too little for 100 snapshots"));
}

TEST(Bands, NameTheTimeOfAValueThatIsNotFinite) {
  MatrixXd q = MatrixXd::Ones(4, 6);
  q(2, 3) = NAN;
  const HeldSnapshots<double> snapshots(steps(6, 0.5, 1), q);
  const Bands<double> bands(snapshots, {});
  EXPECT_THAT(failure_of<InputError>([&] { triangular_factor(bands); }),
              testing::HasSubstr("has nan at t = 2.5 (snapshot 3), point 2 of q"));
}

}  // namespace
}  // namespace pennon::decomposition

#include "analysis/decomposition/spod.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

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

constexpr double dt = 0.5;

template <class Scalar>
Spod spod_of(const DenseMatrix<Scalar>& q, Index length, Taper taper, bool removes_mean = true,
             double overlap = 0.5) {
  const HeldSnapshots<Scalar> snapshots(steps(q.cols(), dt), q);
  const Bands<Scalar> bands(snapshots, {.removes_mean = removes_mean});
  return spod(bands, welch_blocks(q.cols(), length, overlap, taper));
}

double total(const Spod& found) {
  double sum = 0;
  for (const VectorXd& energy : found.energy) sum += energy.sum();
  return sum / (static_cast<double>(found.blocks.length) * dt);
}

// Blocks side by side without a window: Parseval's sum holds to roundoff.
TEST(Spod, AddsUpToTheVariance) {
  for (const Index length : {16, 15}) {
    const MatrixXd q = NormalNumbers(1).matrix(20, 4 * length);
    EXPECT_NEAR(total(spod_of<double>(q, length, Taper::none, false, 0)),
                q.squaredNorm() / static_cast<double>(q.cols()), 1e-10);
    const MatrixXcd z = NormalNumbers(2).complex_matrix(20, 4 * length);
    EXPECT_NEAR(total(spod_of<Complex>(z, length, Taper::none, false, 0)),
                z.squaredNorm() / static_cast<double>(z.cols()), 1e-10);
  }
}

// cos(2 pi f t) phi with 8 periods in a block: its variance stands at f with neighbours by the
// window.
TEST(Spod, FindsAWaveAtItsFrequencyWithItsShape) {
  constexpr Index length = 64, M = 512;
  VectorXd phi = NormalNumbers(3).matrix(30, 1);
  phi.normalize();
  MatrixXd q(30, M);
  const double f = 8 / (length * dt);
  for (Index m = 0; m < M; ++m) q.col(m) = phi * std::cos(2 * pi * f * dt * static_cast<double>(m));
  const HeldSnapshots<double> snapshots(steps(M, dt), q);
  const Bands<double> bands(snapshots, {});
  const Spod found = spod(bands, welch_blocks(M, length, 0.5, Taper::hann));
  const std::vector<Index> highest = peaks(found, 1);
  ASSERT_EQ(highest.size(), 1U);
  EXPECT_NEAR(found.f[static_cast<std::size_t>(highest[0])], f, 1e-12);
  // All energy is in one mode of three frequencies, and the variance of a cosine is a half.
  EXPECT_NEAR(total(found), 0.5, 2e-2);
  MatrixXcd mode(30, 2);
  for_each_band_of_spod_modes<double>(
      bands, found, highest, 2,
      [&](const BandOfData<double>&, std::size_t, const MatrixXcd& part) { mode = part; });
  EXPECT_NEAR(std::abs(mode.col(0).dot(phi.cast<Complex>())), 1, 1e-9);
  EXPECT_LT(found.energy[8](1) / found.energy[8](0), 1e-12);
}

TEST(Spod, TellsTheSenseOfAComplexWave) {
  constexpr Index length = 32, M = 128;
  MatrixXcd q(3, M);
  for (Index m = 0; m < M; ++m)
    q.col(m).setConstant(std::polar(1.0, -2 * pi * 5 * static_cast<double>(m) / length));
  const Spod found = spod_of<Complex>(q, length, Taper::hann, false);
  EXPECT_NEAR(found.f[static_cast<std::size_t>(peaks(found, 1)[0])], -5 / (length * dt), 1e-12);
  EXPECT_TRUE(std::ranges::is_sorted(found.f));
}

// Independent numbers of unit variance: the density is 2 dt for each value at all frequencies but
// the ends, where it is dt.
TEST(Spod, IsFlatForWhiteNoise) {
  constexpr Index values = 5, length = 32, M = 1920;
  const Spod found = spod_of<double>(NormalNumbers(4).matrix(values, M), length, Taper::hamming);
  for (std::size_t f = 1; f + 1 < found.f.size(); ++f) {
    // Five densities of some 110 independent blocks each.
    EXPECT_NEAR(found.energy[f].sum() / (2 * dt * values), 1, 5 / std::sqrt(values * 110.0)) << f;
    // Eigenvalues of 5 x 5 products of so many blocks spread by Marchenko and Pastur's law.
    EXPECT_LT(found.energy[f](0) / found.energy[f](4), 4) << f;
  }
  EXPECT_NEAR(found.energy.back().sum() / (dt * values), 1, 5 / std::sqrt(values * 55.0));
}

// Two modes with coefficients a_m = e_m + c e_(m-1), whose densities are known: 2 dt |1 + c exp(-i
// omega dt)|^2. The interval holds the true one 95 of 100 times.
TEST(Spod, HasAKnownDensityWithinItsInterval) {
  constexpr Index length = 64, M = 512;
  constexpr int draws = 200;
  constexpr Index indices[] = {7, 19, 28};
  int within = 0;
  for (unsigned draw = 0; draw < draws; ++draw) {
    NormalNumbers random(100 + draw);
    const MatrixXd e = random.matrix(2, M + 1);
    MatrixXd q(2, M);
    q.row(0) = e.row(0).tail(M) + 0.6 * e.row(0).head(M);
    q.row(1) = 0.02 * (e.row(1).tail(M) - 0.6 * e.row(1).head(M));
    const Spod found = spod_of<double>(q, length, Taper::hamming);
    for (const Index index : indices) {
      const auto f = static_cast<std::size_t>(index);
      const double density =
          2 * dt * std::norm(1.0 + 0.6 * std::polar(1.0, -2 * pi * found.f[f] * dt));
      const auto interval = energy_interval(found, index);
      const double ratio = density / found.energy[f](0);
      within += interval[0] < ratio && ratio < interval[1] ? 1 : 0;
    }
  }
  const double share = within / (3.0 * draws);
  EXPECT_GE(share, 0.91);
  EXPECT_LE(share, 0.98);
}

TEST(WelchBlocks, AreWorthFewerIndependentOnesWhereTheyOverlap) {
  EXPECT_EQ(welch_blocks(64, 16, 0, Taper::none).count(), 4);
  EXPECT_NEAR(welch_blocks(64, 16, 0, Taper::none).independent(), 4, 1e-12);
  const Blocks half = welch_blocks(16000, 16, 0.5, Taper::none);
  // A rectangle that overlaps by half correlates by a half: 1 + 2/4.
  EXPECT_NEAR(half.independent() / static_cast<double>(half.count()), 1 / 1.5, 1e-3);
  const Blocks hann = welch_blocks(102400, 1024, 0.5, Taper::hann);
  // Hann's correlates by a sixth (Welch 1967).
  EXPECT_NEAR(hann.independent() / static_cast<double>(hann.count()), 1 / (1 + 2.0 / 36), 1e-3);
}

TEST(WelchBlocks, LeaveOutWhatFillsNone) {
  const Blocks blocks = welch_blocks(100, 32, 0.5, Taper::hamming);
  EXPECT_THAT(blocks.first, testing::ElementsAre(0, 16, 32, 48, 64));
  EXPECT_NEAR(blocks.window.squaredNorm(), 32, 1e-12);
  EXPECT_THAT(failure_of<InputError>([] { welch_blocks(20, 32, 0.5, Taper::none); }),
              testing::HasSubstr("decompose.block = 32 is more than the 20 snapshots there are"));
}

}  // namespace
}  // namespace pennon::decomposition

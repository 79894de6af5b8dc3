#include "analysis/decomposition/spod.hpp"

#include <cblas.h>
#include <fftw3.h>
#include <gsl/gsl_cdf.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numeric>

#include "common/interrupt.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// The transform of a block of a few values at a time, so that they stay in the cache.
constexpr Index at_once = 64;

template <class T>
struct FftwMemory {
  explicit FftwMemory(std::size_t count)
      : values(static_cast<T*>(fftw_malloc(count * sizeof(T))), fftw_free) {
    if (!values) throw std::bad_alloc();
  }
  std::unique_ptr<T, decltype(&fftw_free)> values;
};

// Of `at_once` series of N values, one behind the other.
template <class Scalar>
class Transform {
 public:
  explicit Transform(Index length)
      : frequencies_(std::is_same_v<Scalar, double> ? length / 2 + 1 : length),
        in_(static_cast<std::size_t>(length * at_once)),
        out_(static_cast<std::size_t>(frequencies_ * at_once)) {
    const int n = static_cast<int>(length), f = static_cast<int>(frequencies_);
    auto* out = reinterpret_cast<fftw_complex*>(out_.values.get());
    if constexpr (std::is_same_v<Scalar, double>) {
      plan_ = fftw_plan_many_dft_r2c(1, &n, at_once, in_.values.get(), nullptr, 1, n, out, nullptr,
                                     1, f, FFTW_ESTIMATE);
    } else {
      plan_ = fftw_plan_many_dft(1, &n, at_once, reinterpret_cast<fftw_complex*>(in_.values.get()),
                                 nullptr, 1, n, out, nullptr, 1, f, FFTW_FORWARD, FFTW_ESTIMATE);
    }
  }
  ~Transform() { fftw_destroy_plan(plan_); }
  Transform(const Transform&) = delete;
  Transform& operator=(const Transform&) = delete;

  Scalar* in() { return in_.values.get(); }
  const Complex* out() const { return out_.values.get(); }
  void execute() { fftw_execute(plan_); }

 private:
  Index frequencies_;
  FftwMemory<Scalar> in_;
  FftwMemory<Complex> out_;
  fftw_plan plan_;
};

// W^1/2 q^_b of a few values: for each frequency a matrix of values x blocks, one behind the other.
template <class Scalar, class Values>
void transform_values(const Values& A, const Blocks& blocks, const Eigen::VectorXd& w,
                      Transform<Scalar>& transform, std::vector<MatrixXcd>& q) {
  const Index N = blocks.length, frequencies = static_cast<Index>(q.size());
  for (Index i = 0; i < A.rows(); i += at_once) {
    const Index count = std::min(at_once, A.rows() - i);
    for (Index b = 0; b < blocks.count(); ++b) {
      Eigen::Map<DenseMatrix<Scalar>> in(transform.in(), N, at_once);
      const auto part = A.block(i, blocks.first[static_cast<std::size_t>(b)], count, N);
      in.leftCols(count) = w.asDiagonal() * part.transpose();
      in.rightCols(at_once - count).setZero();
      transform.execute();
      const Eigen::Map<const MatrixXcd> out(transform.out(), frequencies, at_once);
      for (Index f = 0; f < frequencies; ++f)
        q[static_cast<std::size_t>(f)].col(b).segment(i, count) = out.row(f).head(count);
    }
  }
}

// Adds q^* q to the lower triangle.
void add_products(const MatrixXcd& q, MatrixXcd& sum) {
  cblas_zherk(CblasColMajor, CblasLower, CblasConjTrans, static_cast<int>(sum.rows()),
              static_cast<int>(q.rows()), 1.0, q.data(), static_cast<int>(q.rows()), 1.0,
              sum.data(), static_cast<int>(sum.rows()));
}

// 2 where the density of real data is one-sided, else 1.
double sides(const Blocks& blocks, Index index, bool is_real) {
  const bool is_alone = index == 0 || 2 * index == blocks.length;
  return is_real && !is_alone ? 2 : 1;
}

// Where the transform has the coefficient of the frequency `index`.
std::size_t coefficient(const Blocks& blocks, Index index, bool is_real) {
  const Index k = blocks.harmonic(index, is_real);
  return static_cast<std::size_t>(k < 0 ? k + blocks.length : k);
}

}  // namespace

std::array<double, 2> energy_interval(const Spod& spod, Index index) {
  if (spod.independent_blocks < 1) return {0, std::numeric_limits<double>::infinity()};
  const bool is_alone = spod.is_real && sides(spod.blocks, index, true) == 1;
  const double freedom = (is_alone ? 1 : 2) * spod.independent_blocks;
  return {freedom / gsl_cdf_chisq_Pinv(0.975, freedom),
          freedom / gsl_cdf_chisq_Pinv(0.025, freedom)};
}

template <class Scalar>
Spod spod(const Bands<Scalar>& bands, const Blocks& blocks) {
  constexpr bool is_real = std::is_same_v<Scalar, double>;
  const Index B = blocks.count(), frequencies = blocks.frequencies(is_real);
  const double dt = bands.times().dt, scale = std::sqrt(dt / static_cast<double>(blocks.length));
  Transform<Scalar> transform(blocks.length);
  std::vector<MatrixXcd> products(static_cast<std::size_t>(frequencies), MatrixXcd::Zero(B, B));
  // So many values at a time, that their transforms stay in the outer cache.
  const double of_value = sizeof(Complex) * static_cast<double>(frequencies * B);
  const Index piece = std::clamp<Index>(static_cast<Index>(8e6 / of_value), at_once, 1024);
  std::vector<MatrixXcd> q(static_cast<std::size_t>(frequencies));
  const Eigen::VectorXd w = blocks.window * scale;
  const double bytes = of_value * static_cast<double>(2 * B + piece);
  bands.for_each(0, bytes, [&](const BandOfData<Scalar>& data) {
    for (Index i = 0; i < data.A.rows(); i += piece) {
      stop_if_interrupted("nothing was written");
      const auto part = data.A.middleRows(i, std::min(piece, data.A.rows() - i));
      for (MatrixXcd& of_frequency : q) of_frequency.resize(part.rows(), B);
      transform_values<Scalar>(part, blocks, w, transform, q);
      for (std::size_t f = 0; f < q.size(); ++f) add_products(q[f], products[f]);
    }
  });
  Spod found{blocks, {}, {}, {}, blocks.independent(), is_real};
  for (Index f = 0; f < frequencies; ++f) {
    MatrixXcd& product = products[coefficient(blocks, f, is_real)];
    ranks::sum({reinterpret_cast<double*>(product.data()), static_cast<std::size_t>(2 * B * B)});
    product *= sides(blocks, f, is_real) / static_cast<double>(B);
    const Eigen::SelfAdjointEigenSolver<MatrixXcd> solver(product);  // of the lower triangle
    found.f.push_back(static_cast<double>(blocks.harmonic(f, is_real)) /
                      (static_cast<double>(blocks.length) * dt));
    const auto count = std::min<Index>(B, static_cast<Index>(bands.layout().values()));
    found.energy.emplace_back(solver.eigenvalues().reverse().head(count).cwiseMax(0));
    found.v.emplace_back(solver.eigenvectors().rowwise().reverse().leftCols(count));
  }
  return found;
}

std::vector<Index> peaks(const Spod& spod, std::size_t count) {
  const auto first = [&](std::size_t f) { return spod.energy[f](0); };
  const std::size_t last = spod.f.size() - 1;
  std::vector<Index> found;
  for (std::size_t f = 0; f <= last; ++f)
    if (first(f) > 0 && (f == 0 || first(f) > first(f - 1)) &&
        (f == last || first(f) >= first(f + 1)))
      found.push_back(static_cast<Index>(f));
  std::ranges::stable_sort(found, std::ranges::greater(),
                           [&](Index f) { return first(static_cast<std::size_t>(f)); });
  found.resize(std::min(found.size(), count));
  return found;
}

template <class Scalar>
void for_each_band_of_spod_modes(const Bands<Scalar>& bands, const Spod& spod,
                                 const std::vector<Index>& frequencies, Index modes,
                                 const UseSpodModes<Scalar>& use) {
  const Blocks& blocks = spod.blocks;
  const Index N = blocks.length, B = blocks.count();
  const double dt = bands.times().dt, scale = std::sqrt(dt / static_cast<double>(N));
  // The factors of the transform at each frequency, real and imaginary parts beside each other.
  const auto chosen = static_cast<Index>(frequencies.size());
  MatrixXcd waves(N, chosen);
  for (Index k = 0; k < chosen; ++k) {
    const auto turns = static_cast<Index>(
        coefficient(blocks, frequencies[static_cast<std::size_t>(k)], spod.is_real));
    for (Index m = 0; m < N; ++m)
      waves(m, k) = std::polar(
          scale * blocks.window(m),
          -2 * std::numbers::pi * static_cast<double>(turns * m % N) / static_cast<double>(N));
  }
  std::vector<MatrixXcd> q(frequencies.size());
  const double of_value = sizeof(Complex) * static_cast<double>(chosen * (B + 1) + 2 * modes);
  bands.for_each(of_value, 0, [&](const BandOfData<Scalar>& data) {
    for (MatrixXcd& of_frequency : q) of_frequency.resize(data.A.rows(), B);
    for (Index i = 0; i < data.A.rows(); i += at_once) {
      const Index count = std::min(at_once, data.A.rows() - i);
      for (Index b = 0; b < B; ++b) {
        const MatrixXcd of_block =
            data.A.block(i, blocks.first[static_cast<std::size_t>(b)], count, N) * waves;
        for (Index k = 0; k < chosen; ++k)
          q[static_cast<std::size_t>(k)].col(b).segment(i, count) = of_block.col(k);
      }
    }
    for (std::size_t k = 0; k < frequencies.size(); ++k) {
      const auto f = static_cast<std::size_t>(frequencies[k]);
      const Eigen::VectorXd& energy = spod.energy[f];
      const Index count = std::min(modes, energy.size());
      MatrixXcd phi = q[k] * spod.v[f].leftCols(count);
      const double factor =
          std::sqrt(sides(blocks, frequencies[k], spod.is_real) / static_cast<double>(B));
      for (Index j = 0; j < count; ++j)
        phi.col(j) *= energy(j) > 0 ? factor / std::sqrt(energy(j)) : 0;
      data.take_weight_from(phi);
      use(data, k, phi);
    }
  });
}

template Spod spod(const Bands<double>&, const Blocks&);
template Spod spod(const Bands<Complex>&, const Blocks&);
template void for_each_band_of_spod_modes(const Bands<double>&, const Spod&,
                                          const std::vector<Index>&, Index,
                                          const UseSpodModes<double>&);
template void for_each_band_of_spod_modes(const Bands<Complex>&, const Spod&,
                                          const std::vector<Index>&, Index,
                                          const UseSpodModes<Complex>&);

}  // namespace pennon::decomposition

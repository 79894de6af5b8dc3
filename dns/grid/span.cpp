#include "dns/grid/span.hpp"

#include <cblas.h>
#include <fftw3.h>
#include <fmt/format.h>
#include <mpi.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::dns {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Columns along x are gathered so many at a time: what is transformed stays in the cache.
constexpr std::size_t block = 128;
// Up to so many planes a product with a matrix is faster than the fast transforms, which do not
// fill vector registers: measured, docs/accuracy.md.
constexpr int most_planes_of_matrix = 128;

}  // namespace

// What is done to columns along x, `block` of them side by side: by a matrix, or where there are
// many planes by FFTW's half-complex transforms. These are planned by estimate: every run takes the
// same.
class Span::Columns {
 public:
  Columns(int planes, double length) : planes_(planes) {
    if (planes_ > most_planes_of_matrix) {
      plan();
      return;
    }
    to_coefficients_.resize(planes, planes);
    to_values_.resize(planes, planes);
    Matrix derivative = Matrix::Zero(planes, planes), kept = Matrix::Zero(planes, planes);
    for (int c = 0; c < planes; ++c) {
      const bool is_sine = 2 * c > planes;
      const int waves = is_sine ? planes - c : c;
      const bool is_alone = waves == 0 || 2 * waves == planes;
      for (int m = 0; m < planes; ++m) {
        const double phase = 2 * std::numbers::pi * (waves * m % planes) / planes;
        const double wave = is_sine ? -std::sin(phase) : std::cos(phase);
        to_coefficients_(c, m) = wave / planes;
        to_values_(m, c) = (is_alone ? 1 : 2) * wave;
      }
      kept(c, c) = waves <= highest_kept() ? 1 : 0;
      if (is_alone) continue;
      // (c + i s) -> i k (c + i s)
      const double k = wavenumber(waves, planes, length);
      if (is_sine)
        derivative(waves, c) = -k;
      else
        derivative(planes - waves, c) = k;
    }
    derivative_ = to_values_ * derivative * to_coefficients_;
    dealiasing_ = to_values_ * kept * to_coefficients_;
  }
  ~Columns() {
    if (forward_) fftw_destroy_plan(forward_);
    if (backward_) fftw_destroy_plan(backward_);
  }
  Columns(const Columns&) = delete;
  Columns& operator=(const Columns&) = delete;

  // Each changes `count` <= block columns, rows `stride` apart, into `result`, rows `to` apart.
  void to_coefficients(const double* columns, std::size_t stride, std::size_t count, double* result,
                       std::size_t to) {
    apply(to_coefficients_, columns, stride, count, result, to, [this](double* work) {
      fftw_execute_r2r(forward_, work, work);
      for (std::size_t k = 0; k < size(); ++k) work[k] /= planes_;
    });
  }
  void to_values(const double* columns, std::size_t stride, std::size_t count, double* result,
                 std::size_t to) {
    apply(to_values_, columns, stride, count, result, to,
          [this](double* work) { fftw_execute_r2r(backward_, work, work); });
  }
  void differentiate(double length, const double* columns, std::size_t stride, std::size_t count,
                     double* result, std::size_t to) {
    apply(derivative_, columns, stride, count, result, to, [this, length](double* work) {
      fftw_execute_r2r(forward_, work, work);
      const auto row = [&](int m) { return work + static_cast<std::size_t>(m) * block; };
      std::fill_n(row(0), block, 0.0);
      for (int m = 1; 2 * m < planes_; ++m) {
        const double k = wavenumber(m, planes_, length) / planes_;
        double *cosine = row(m), *sine = row(planes_ - m);
        for (std::size_t b = 0; b < block; ++b) {
          const double c = cosine[b];
          cosine[b] = -k * sine[b];
          sine[b] = k * c;
        }
      }
      if (planes_ % 2 == 0) std::fill_n(row(planes_ / 2), block, 0.0);
      fftw_execute_r2r(backward_, work, work);
    });
  }
  void dealias(const double* columns, std::size_t stride, std::size_t count, double* result,
               std::size_t to) {
    apply(dealiasing_, columns, stride, count, result, to, [this](double* work) {
      fftw_execute_r2r(forward_, work, work);
      for (int m = 0; m < planes_; ++m) {
        double* row = work + static_cast<std::size_t>(m) * block;
        const bool is_kept = std::min(m, planes_ - m) <= highest_kept();
        for (std::size_t b = 0; b < block; ++b) row[b] = is_kept ? row[b] / planes_ : 0.0;
      }
      fftw_execute_r2r(backward_, work, work);
    });
  }

 private:
  int highest_kept() const { return (planes_ - 1) / 3; }
  std::size_t size() const { return static_cast<std::size_t>(planes_) * block; }

  template <class Fast>
  void apply(const Matrix& matrix, const double* columns, std::size_t stride, std::size_t count,
             double* result, std::size_t to, const Fast& fast) {
    work_.resize(size());
    for (std::size_t m = 0; m < static_cast<std::size_t>(planes_); ++m)
      std::copy_n(columns + m * stride, count, work_.data() + m * block);
    if (!forward_) {
      cblas_dgemm(CblasRowMajor, CblasNoTrans, CblasNoTrans, planes_, static_cast<int>(count),
                  planes_, 1.0, matrix.data(), planes_, work_.data(), static_cast<int>(block), 0.0,
                  result, static_cast<int>(to));
      return;
    }
    fast(work_.data());
    for (std::size_t m = 0; m < static_cast<std::size_t>(planes_); ++m)
      std::copy_n(work_.data() + m * block, count, result + m * to);
  }

  void plan() {
    work_.resize(size());
    const auto planned = [&](fftw_r2r_kind kind) {
      constexpr int stride = block;
      return fftw_plan_many_r2r(1, &planes_, stride, work_.data(), nullptr, stride, 1, work_.data(),
                                nullptr, stride, 1, &kind, FFTW_ESTIMATE | FFTW_UNALIGNED);
    };
    forward_ = planned(FFTW_R2HC);
    backward_ = planned(FFTW_HC2R);
  }

  int planes_;
  Matrix to_coefficients_, to_values_, derivative_, dealiasing_;
  fftw_plan forward_ = nullptr, backward_ = nullptr;
  std::vector<double> work_;
};

// The planes of each rank on one side, the points of each on the other.
struct Span::Exchange {
  int ranks, rank;
  std::vector<int> first_plane;  // of each rank, and one behind the last
  std::vector<double> outgoing, columns;
  std::vector<int> send_counts, send_offsets, receive_counts, receive_offsets;

  explicit Exchange(int planes) : ranks(ranks::count()), rank(ranks::mine()) {
    for (int r = 0; r <= ranks; ++r) first_plane.push_back(first_of(planes, r));
    for (std::vector<int>* counts :
         {&send_counts, &send_offsets, &receive_counts, &receive_offsets})
      counts->resize(static_cast<std::size_t>(ranks));
  }

  // The first of `count` things that belongs to a rank.
  int first_of(int count, int r) const { return static_cast<int>(std::int64_t(count) * r / ranks); }
  int planes_of(int r) const {
    return first_plane[static_cast<std::size_t>(r) + 1] - first_plane[static_cast<std::size_t>(r)];
  }

  // The columns of this rank's points, plane by plane, from the planes of this rank; and back.
  void share(const double* planes, int points, std::size_t stride) {
    prepare(points);
    double* to = outgoing.data();
    for (int r = 0; r < ranks; ++r)
      for (int m = 0; m < planes_of(rank); ++m)
        to = std::copy(planes + static_cast<std::size_t>(m) * stride + first_of(points, r),
                       planes + static_cast<std::size_t>(m) * stride + first_of(points, r + 1), to);
    MPI_Alltoallv(outgoing.data(), send_counts.data(), send_offsets.data(), MPI_DOUBLE,
                  columns.data(), receive_counts.data(), receive_offsets.data(), MPI_DOUBLE,
                  MPI_COMM_WORLD);
  }
  void bring_back(double* planes, int points, std::size_t stride) {
    MPI_Alltoallv(columns.data(), receive_counts.data(), receive_offsets.data(), MPI_DOUBLE,
                  outgoing.data(), send_counts.data(), send_offsets.data(), MPI_DOUBLE,
                  MPI_COMM_WORLD);
    const double* from = outgoing.data();
    for (int r = 0; r < ranks; ++r)
      for (int m = 0; m < planes_of(rank); ++m) {
        const int count = first_of(points, r + 1) - first_of(points, r);
        std::copy_n(from, count,
                    planes + static_cast<std::size_t>(m) * stride + first_of(points, r));
        from += count;
      }
  }

 private:
  void prepare(int points) {
    const int mine = first_of(points, rank + 1) - first_of(points, rank);
    int sent = 0, received = 0;
    for (int r = 0; r < ranks; ++r) {
      const auto k = static_cast<std::size_t>(r);
      send_offsets[k] = sent;
      send_counts[k] = planes_of(rank) * (first_of(points, r + 1) - first_of(points, r));
      sent += send_counts[k];
      receive_offsets[k] = received;
      receive_counts[k] = planes_of(r) * mine;
      received += receive_counts[k];
    }
    outgoing.resize(static_cast<std::size_t>(sent));
    columns.resize(static_cast<std::size_t>(received));
  }
};

Span::Span(int planes, double length)
    : planes_(planes),
      length_(length),
      columns_(planes > 1 ? std::make_unique<Columns>(planes, length) : nullptr) {
  const int ranks = ranks::count();
  if (ranks > planes)
    throw InputError(
        "mpiexec",
        fmt::format("started {} ranks, but they share planes of the span, of which "
                    "there {}; start at most as many ranks",
                    ranks,
                    planes == 1 ? "is one in two dimensions" : fmt::format("are {}", planes)));
  if (ranks > 1) exchange_ = std::make_unique<Exchange>(planes);
  first_plane_ = exchange_ ? exchange_->first_plane[static_cast<std::size_t>(exchange_->rank)] : 0;
  local_planes_ = exchange_ ? exchange_->planes_of(exchange_->rank) : planes;
}
Span::~Span() = default;
Span::Span(Span&&) noexcept = default;
Span& Span::operator=(Span&&) noexcept = default;

int Span::waves(int plane) const {
  const int m = first_plane_ + plane;
  return std::min(m, planes_ - m);
}

double Span::wavenumber(int waves, int planes, double length) {
  return planes == 1 || 2 * waves == planes ? 0.0 : 2 * std::numbers::pi / length * waves;
}

// Applies `change` to blocks of whole columns along x.
template <class Change>
void Span::transform(const double* from, double* to, std::size_t points, std::size_t stride,
                     const Change& change) const {
  const auto change_all = [&](const double* source, double* target, std::size_t width,
                              std::size_t rows) {
    for (std::size_t first = 0; first < width; first += block)
      change(source + first, rows, std::min(block, width - first), target + first, rows);
  };
  if (!exchange_) {
    change_all(from, to, points, stride);
    return;
  }
  exchange_->share(from, static_cast<int>(points), stride);
  double* columns = exchange_->columns.data();
  const std::size_t width = exchange_->columns.size() / static_cast<std::size_t>(planes_);
  change_all(columns, columns, width, width);
  exchange_->bring_back(to, static_cast<int>(points), stride);
}

void Span::to_coefficients(double* values, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  transform(values, values, points, stride,
            [this](auto... block_of_columns) { columns_->to_coefficients(block_of_columns...); });
}

void Span::to_values(double* coefficients, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  transform(coefficients, coefficients, points, stride,
            [this](auto... block_of_columns) { columns_->to_values(block_of_columns...); });
}

void Span::differentiate(const Field<double>& f, Field<double>& f_x) const {
  const std::size_t stride = f.values().size() / static_cast<std::size_t>(local_planes_);
  transform(
      f.values().data(), f_x.values().data(), stride, stride,
      [this](auto... block_of_columns) { columns_->differentiate(length_, block_of_columns...); });
}

void Span::dealias(double* values, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  transform(values, values, points, stride,
            [this](auto... block_of_columns) { columns_->dealias(block_of_columns...); });
}

}  // namespace pennon::dns

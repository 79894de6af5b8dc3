#include "dns/span.hpp"

#include <fftw3.h>
#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <cstdint>
#include <numbers>
#include <vector>

#include "common/errors.hpp"
#include "common/ranks.hpp"

namespace pennon::dns {
namespace {

// Columns along x are gathered so many at a time: what is transformed stays in the cache.
constexpr std::size_t block = 32;

}  // namespace

// Half-complex transforms of `block` interleaved columns, planned by estimate: every run takes the
// same.
struct Span::Plans {
  fftw_plan forward, backward;

  explicit Plans(int planes) {
    std::vector<double> columns(static_cast<std::size_t>(planes) * block);
    const auto plan = [&](fftw_r2r_kind kind) {
      constexpr int stride = block;
      return fftw_plan_many_r2r(1, &planes, stride, columns.data(), nullptr, stride, 1,
                                columns.data(), nullptr, stride, 1, &kind,
                                FFTW_ESTIMATE | FFTW_UNALIGNED);
    };
    forward = plan(FFTW_R2HC);
    backward = plan(FFTW_HC2R);
  }
  ~Plans() {
    fftw_destroy_plan(forward);
    fftw_destroy_plan(backward);
  }
  Plans(const Plans&) = delete;
  Plans& operator=(const Plans&) = delete;
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
      plans_(planes > 1 ? std::make_unique<Plans>(planes) : nullptr) {
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
  const auto planes = static_cast<std::size_t>(planes_);
  std::vector<double> columns(planes * block);
  const auto change_columns = [&](const double* source, double* target, std::size_t width,
                                  std::size_t source_stride, std::size_t target_stride) {
    for (std::size_t first = 0; first < width; first += block) {
      const std::size_t count = std::min(block, width - first);
      for (std::size_t m = 0; m < planes; ++m)
        std::copy_n(source + m * source_stride + first, count, columns.data() + m * block);
      change(columns.data());
      for (std::size_t m = 0; m < planes; ++m)
        std::copy_n(columns.data() + m * block, count, target + m * target_stride + first);
    }
  };
  if (!exchange_) {
    change_columns(from, to, points, stride, stride);
    return;
  }
  exchange_->share(from, static_cast<int>(points), stride);
  const std::size_t width = exchange_->columns.size() / planes;
  change_columns(exchange_->columns.data(), exchange_->columns.data(), width, width, width);
  exchange_->bring_back(to, static_cast<int>(points), stride);
}

void Span::to_coefficients(double* values, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  transform(values, values, points, stride, [&](double* columns) {
    fftw_execute_r2r(plans_->forward, columns, columns);
    for (std::size_t k = 0; k < static_cast<std::size_t>(planes_) * block; ++k)
      columns[k] /= planes_;
  });
}

void Span::to_values(double* coefficients, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  transform(coefficients, coefficients, points, stride,
            [&](double* columns) { fftw_execute_r2r(plans_->backward, columns, columns); });
}

void Span::differentiate(const Field<double>& f, Field<double>& f_x) const {
  const std::size_t stride = f.values().size() / static_cast<std::size_t>(local_planes_);
  transform(f.values().data(), f_x.values().data(), stride, stride, [&](double* columns) {
    fftw_execute_r2r(plans_->forward, columns, columns);
    const auto row = [&](int m) { return columns + static_cast<std::size_t>(m) * block; };
    std::fill_n(row(0), block, 0.0);
    for (int m = 1; 2 * m < planes_;
         ++m) {  // c cos + s sin (as Re, Im of c + i s) -> i k (c + i s)
      const double k = wavenumber(m, planes_, length_) / planes_;
      double *cosine = row(m), *sine = row(planes_ - m);
      for (std::size_t b = 0; b < block; ++b) {
        const double c = cosine[b];
        cosine[b] = -k * sine[b];
        sine[b] = k * c;
      }
    }
    if (planes_ % 2 == 0) std::fill_n(row(planes_ / 2), block, 0.0);
    fftw_execute_r2r(plans_->backward, columns, columns);
  });
}

void Span::dealias(double* values, std::size_t points, std::size_t stride) const {
  if (!has_span()) return;
  const int highest = (planes_ - 1) / 3;
  transform(values, values, points, stride, [&](double* columns) {
    fftw_execute_r2r(plans_->forward, columns, columns);
    for (int m = 0; m < planes_; ++m) {
      double* row = columns + static_cast<std::size_t>(m) * block;
      const bool is_kept = std::min(m, planes_ - m) <= highest;
      for (std::size_t b = 0; b < block; ++b) row[b] = is_kept ? row[b] / planes_ : 0.0;
    }
    fftw_execute_r2r(plans_->backward, columns, columns);
  });
}

}  // namespace pennon::dns

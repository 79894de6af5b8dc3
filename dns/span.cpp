#include "dns/span.hpp"

#include <fftw3.h>

#include <algorithm>
#include <numbers>
#include <vector>

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

Span::Span(int planes, double length)
    : planes_(planes),
      length_(length),
      plans_(planes > 1 ? std::make_unique<Plans>(planes) : nullptr) {}
Span::~Span() = default;
Span::Span(Span&&) noexcept = default;
Span& Span::operator=(Span&&) noexcept = default;

double Span::wavenumber(int plane) const {
  if (planes_ == 1 || is_dropped(plane)) return 0;
  return 2 * std::numbers::pi / length_ * (2 * plane < planes_ ? plane : plane - planes_);
}

template <class Change>
void Span::transform(const double* from, double* to, std::size_t points, std::size_t stride,
                     const Change& change) const {
  const auto planes = static_cast<std::size_t>(planes_);
  std::vector<double> columns(planes * block);
  for (std::size_t first = 0; first < points; first += block) {
    const std::size_t count = std::min(block, points - first);
    for (std::size_t m = 0; m < planes; ++m)
      std::copy_n(from + m * stride + first, count, columns.data() + m * block);
    change(columns.data());
    for (std::size_t m = 0; m < planes; ++m)
      std::copy_n(columns.data() + m * block, count, to + m * stride + first);
  }
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
  const std::size_t stride = f.values().size() / static_cast<std::size_t>(planes_);
  transform(f.values().data(), f_x.values().data(), stride, stride, [&](double* columns) {
    fftw_execute_r2r(plans_->forward, columns, columns);
    const auto row = [&](int m) { return columns + static_cast<std::size_t>(m) * block; };
    std::fill_n(row(0), block, 0.0);
    for (int m = 1; 2 * m < planes_;
         ++m) {  // c cos + s sin (as Re, Im of c + i s) -> i k (c + i s)
      const double k = wavenumber(m) / planes_;
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

#include "analysis/signal/series.hpp"

#include <gsl/gsl_spline.h>

#include <algorithm>
#include <cassert>
#include <new>

namespace pennon::analysis {

struct Spline::Table {
  explicit Table(std::size_t count) : spline(gsl_spline_alloc(gsl_interp_cspline, count)) {
    if (spline == nullptr) throw std::bad_alloc();
  }
  ~Table() { gsl_spline_free(spline); }
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  gsl_spline* spline;
};

Spline::Spline(const std::vector<double>& t, const std::vector<double>& values)
    : table_(std::make_unique<Table>(t.size())) {
  assert(t.size() == values.size() && t.size() >= 3);
  gsl_spline_init(table_->spline, t.data(), values.data(), t.size());
}
Spline::~Spline() = default;
Spline::Spline(Spline&&) noexcept = default;
Spline& Spline::operator=(Spline&&) noexcept = default;

double Spline::operator()(double t) const {
  const gsl_interp* ends = table_->spline->interp;
  return gsl_spline_eval(table_->spline, std::clamp(t, ends->xmin, ends->xmax), nullptr);
}

double Spline::integral(double from, double to) const {
  const gsl_interp* ends = table_->spline->interp;
  return gsl_spline_eval_integ(table_->spline, std::clamp(from, ends->xmin, ends->xmax),
                               std::clamp(to, ends->xmin, ends->xmax), nullptr);
}

std::vector<double> equal_times(double from, double to, std::size_t count) {
  assert(count >= 2);
  std::vector<double> times;
  times.reserve(count);
  for (std::size_t k = 0; k < count; ++k)
    times.push_back(from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1));
  return times;
}

std::vector<double> at_times(const std::vector<double>& t, const std::vector<double>& values,
                             const std::vector<double>& times) {
  const Spline spline(t, values);
  std::vector<double> found;
  found.reserve(times.size());
  for (const double time : times) found.push_back(spline(time));
  return found;
}

std::vector<std::complex<double>> at_times(const std::vector<double>& t,
                                           const std::vector<std::complex<double>>& values,
                                           const std::vector<double>& times) {
  std::vector<double> real, imaginary;
  for (const std::complex<double>& value : values) {
    real.push_back(value.real());
    imaginary.push_back(value.imag());
  }
  const std::vector<double> a = at_times(t, real, times), b = at_times(t, imaginary, times);
  std::vector<std::complex<double>> found;
  found.reserve(times.size());
  for (std::size_t k = 0; k < times.size(); ++k) found.emplace_back(a[k], b[k]);
  return found;
}

std::vector<double> running_integral(const std::vector<double>& t,
                                     const std::vector<double>& values) {
  std::vector<double> sums = {0};
  for (std::size_t r = 1; r < t.size(); ++r)
    sums.push_back(sums.back() + (t[r] - t[r - 1]) * (values[r] + values[r - 1]) / 2);
  return sums;
}

double begin_of_last(double share, const std::vector<double>& t) {
  return t.back() - share * (t.back() - t.front());
}

Rows rows_between(const std::vector<double>& t, double from, double to) {
  return {static_cast<std::size_t>(std::ranges::lower_bound(t, from) - t.begin()),
          static_cast<std::size_t>(std::ranges::upper_bound(t, to) - t.begin())};
}

double half_range(const std::vector<double>& values, Rows rows) {
  if (rows.begin >= rows.end) return 0;
  const auto [low, high] =
      std::minmax_element(values.begin() + static_cast<std::ptrdiff_t>(rows.begin),
                          values.begin() + static_cast<std::ptrdiff_t>(rows.end));
  return (*high - *low) / 2;
}

}  // namespace pennon::analysis

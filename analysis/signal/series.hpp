/// A quantity over time, on rows that need not be equally spaced: what a history holds.
#pragma once

#include <complex>
#include <memory>
#include <vector>

namespace pennon::analysis {

/// The natural cubic spline through values at increasing times, at least three; exact to the fourth
/// order of their spacing away from the ends, to the second there.
class Spline {
 public:
  Spline(const std::vector<double>& t, const std::vector<double>& values);
  ~Spline();
  Spline(const Spline&) = delete;
  Spline& operator=(const Spline&) = delete;
  Spline(Spline&&) noexcept;
  Spline& operator=(Spline&&) noexcept;

  /// A time outside the rows counts as the nearest one inside.
  double operator()(double t) const;
  /// The integral between two times inside the rows.
  double integral(double from, double to) const;

 private:
  struct Table;
  std::unique_ptr<Table> table_;
};

/// `count` equally spaced times, both ends included.
std::vector<double> equal_times(double from, double to, std::size_t count);

/// The values at other times, by the spline.
std::vector<double> at_times(const std::vector<double>& t, const std::vector<double>& values,
                             const std::vector<double>& times);
std::vector<std::complex<double>> at_times(const std::vector<double>& t,
                                           const std::vector<std::complex<double>>& values,
                                           const std::vector<double>& times);

/// The integral of values from the first row to each row, by the trapezoidal rule.
std::vector<double> running_integral(const std::vector<double>& t,
                                     const std::vector<double>& values);

/// When the last part of the rows begins, a share of their time.
double begin_of_last(double share, const std::vector<double>& t);

/// The rows between two times, the first and the one past the last.
struct Rows {
  std::size_t begin, end;
};
Rows rows_between(const std::vector<double>& t, double from, double to);

/// Half the range of the values in some rows: the amplitude of what swings about any mean.
double half_range(const std::vector<double>& values, Rows);

}  // namespace pennon::analysis

#include "analysis/signal/spanwise_amplitudes.hpp"

#include <fftw3.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "analysis/signal/series.hpp"

namespace pennon::analysis {
namespace {

using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, decltype(&fftw_destroy_plan)>;

}  // namespace

std::vector<Complexes> spanwise_components(const std::vector<std::vector<double>>& values) {
  const std::size_t stations = values.size(), rows = values.front().size();
  std::vector<double> station_values(stations);
  Complexes coefficients(stations / 2 + 1);
  const Plan plan(
      fftw_plan_dft_r2c_1d(static_cast<int>(stations), station_values.data(),
                           reinterpret_cast<fftw_complex*>(coefficients.data()), FFTW_ESTIMATE),
      fftw_destroy_plan);
  std::vector<Complexes> components(std::min(highest_wave + 1, stations / 2 + 1));
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t m = 0; m < stations; ++m) station_values[m] = values[m][row];
    fftw_execute(plan.get());
    for (std::size_t n = 0; n < components.size(); ++n) {
      const bool is_alone = n == 0 || 2 * n == stations;
      components[n].push_back(coefficients[n] * (is_alone ? 1.0 : 2.0) /
                              static_cast<double>(stations));
    }
  }
  return components;
}

std::vector<double> between_stations(const std::vector<std::vector<double>>& values, double share) {
  const std::size_t stations = values.size(), rows = values.front().size();
  const auto N = static_cast<double>(stations);
  std::vector<double> found(rows, 0.0);
  for (std::size_t m = 0; m < stations; ++m) {
    // Dirichlet's kernel: 1 at its own station, 0 at the others.
    const double half = std::numbers::pi * (share - static_cast<double>(m) / N);
    const double below = stations % 2 == 0 ? std::tan(half) : std::sin(half);
    constexpr double rounding = 1e-12;
    const bool is_at_station = std::abs(std::sin(half)) < rounding;
    const double weight = is_at_station ? 1 : std::sin(N * half) / (N * below);
    for (std::size_t row = 0; row < rows; ++row) found[row] += weight * values[m][row];
  }
  return found;
}

std::vector<std::vector<double>> moduli(const std::vector<Complexes>& components) {
  std::vector<std::vector<double>> sizes(components.size());
  for (std::size_t n = 0; n < components.size(); ++n)
    for (const std::complex<double>& value : components[n]) sizes[n].push_back(std::abs(value));
  return sizes;
}

std::vector<double> envelope(const std::vector<double>& t, const std::vector<double>& values,
                             double period) {
  std::vector<double> largest;
  largest.reserve(t.size());
  for (const double time : t) {
    const Rows rows = rows_between(t, time - period / 2, time + period / 2);
    largest.push_back(*std::max_element(values.begin() + static_cast<std::ptrdiff_t>(rows.begin),
                                        values.begin() + static_cast<std::ptrdiff_t>(rows.end)));
  }
  return largest;
}

}  // namespace pennon::analysis

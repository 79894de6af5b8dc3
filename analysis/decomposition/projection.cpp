#include "analysis/decomposition/projection.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <numbers>

#include "analysis/decomposition/triangular_factor.hpp"
#include "common/errors.hpp"
#include "common/linear_algebra/stacked_qr.hpp"
#include "common/linear_algebra/svd.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Each mode's real part, and unless it stands, minus its imaginary part, at a value of the data.
class Columns {
 public:
  Columns(const Layout& layout, const std::vector<GivenMode>& modes)
      : layout_(layout), modes_(modes) {
    for (const GivenMode& mode : modes) count_ += mode.is_standing ? 1 : 2;
  }
  Index count() const { return count_; }

  MatrixXd of(Band band) const {
    MatrixXd columns(static_cast<Index>(band.count), count_);
    for (std::size_t i = 0; i < band.count; ++i) {
      const std::size_t point = band.first + i;
      Index column = 0;
      for (const GivenMode& mode : modes_) {
        const Complex value = mode.Y(layout_.y[point]) * std::polar(1.0, mode.k * x(point));
        columns(static_cast<Index>(i), column++) = value.real();
        if (!mode.is_standing) columns(static_cast<Index>(i), column++) = -value.imag();
      }
    }
    return columns;
  }

 private:
  double x(std::size_t point) const {
    if (!layout_.stations) return 0;
    const std::size_t of_station = layout_.points / layout_.stations->count;
    const std::size_t station = point / of_station;
    return layout_.stations->span * static_cast<double>(station) /
           static_cast<double>(layout_.stations->count);
  }

  const Layout& layout_;
  const std::vector<GivenMode>& modes_;
  Index count_ = 0;
};

void expect_shapes(const Layout& layout, const std::vector<GivenMode>& modes) {
  const bool has_span = layout.stations.has_value();
  for (const GivenMode& mode : modes) {
    if (mode.k == 0) continue;
    if (!has_span)
      throw InputError("[decompose]",
                       fmt::format("{} has k_x = {}, and the shapes in {} have no span", mode.name,
                                   mode.k, layout.name));
    const double waves = std::abs(mode.k) * layout.stations->span / (2 * std::numbers::pi);
    constexpr double slack = 1e-6;
    if (std::abs(waves - std::round(waves)) > slack)
      throw InputError(
          "[decompose]",
          fmt::format("{} has {:.6g} waves (k_x = {}) in the span {} of {}; it must be a whole "
                      "number",
                      mode.name, waves, mode.k, layout.stations->span, layout.name));
    if (2 * waves >= static_cast<double>(layout.stations->count))
      throw InputError(
          "[decompose]",
          fmt::format("{} has {:.0f} waves in the span, which {} stations do not resolve",
                      mode.name, waves, layout.stations->count));
  }
}

// The slope of a straight line through values, and its standard deviation.
std::pair<double, double> slope(const std::vector<double>& t, const VectorXd& values) {
  const Index M = values.size();
  MatrixXd line(M, 2);
  for (Index m = 0; m < M; ++m) line.row(m) << 1, t[static_cast<std::size_t>(m)] - t.front();
  const Eigen::Vector2d fit = line.colPivHouseholderQr().solve(values);
  const double rest =
      (values - line * fit).squaredNorm() / static_cast<double>(std::max<Index>(M - 2, 1));
  const double spread = (line.col(1).array() - line.col(1).mean()).square().sum();
  return {fit(1), std::sqrt(rest / spread)};
}

}  // namespace

Slopes slopes_of(const std::vector<double>& t, const Eigen::VectorXcd& a) {
  VectorXd logarithm(a.size()), phase(a.size());
  for (Index m = 0; m < a.size(); ++m) {
    logarithm(m) = std::log(std::max(std::abs(a(m)), 1e-300));
    const double turn = m > 0 ? std::arg(a(m) * std::conj(a(m - 1))) : 0;
    phase(m) = m > 0 ? phase(m - 1) + turn : std::arg(a(0));
  }
  const auto [growth, growth_error] = slope(t, logarithm);
  const auto [omega, omega_error] = slope(t, phase);
  return {growth, growth_error, omega, omega_error};
}

Projection project(const Bands<double>& bands, std::vector<GivenMode> modes) {
  const Layout& layout = bands.layout();
  if (layout.y.empty())
    throw InputError("[decompose]", "the modes are shapes of a flag, and " + layout.name +
                                        " holds none (z with y, or a run)");
  expect_shapes(layout, modes);
  const Columns columns(layout, modes);
  const Index K = columns.count(), M = bands.snapshots();
  StackedQr<double> factor(K + M);
  const auto bytes = static_cast<double>((K + M) * (K + M) * 3) * sizeof(double);
  bands.for_each(
      static_cast<double>(K + M) * sizeof(double), bytes, [&](const BandOfData<double>& data) {
        MatrixXd both(data.A.rows(), K + M);
        both.leftCols(K) = data.mean_weight.cwiseSqrt().asDiagonal() * columns.of(data.band);
        both.rightCols(M) = data.A;
        factor.add(std::move(both));
      });
  const MatrixXd R = gathered_factor(factor.R());
  const VectorXd size = R.leftCols(K).colwise().norm().cwiseMax(1e-300);
  const MatrixXd scaled = R.leftCols(K) * size.cwiseInverse().asDiagonal();
  const VectorXd singular = singular_values(scaled);
  constexpr double undetermined = 1e-12;
  if (scaled.rows() < K || !(singular(K - 1) > undetermined * singular(0)))
    throw InputError(
        "[decompose]",
        fmt::format("{} nodes do not tell {} modes apart ({} amplitudes): some sum of them "
                    "vanishes at all nodes; take fewer modes",
                    layout.points, modes.size(), K));
  const MatrixXd found = scaled.householderQr().solve(R.rightCols(M));
  const MatrixXd left = R.rightCols(M) - scaled * found;
  Projection projection{std::move(modes), Eigen::MatrixXcd::Zero(0, 0), left.colwise().norm(),
                        R.rightCols(M).colwise().norm(), singular(0) / singular(K - 1)};
  projection.a.resize(static_cast<Index>(projection.modes.size()), M);
  Index column = 0;
  for (Index j = 0; j < projection.a.rows(); ++j) {
    projection.a.row(j) = (found.row(column) / size(column)).cast<Complex>();
    ++column;
    if (projection.modes[static_cast<std::size_t>(j)].is_standing) continue;
    projection.a.row(j) += Complex(0, 1) * (found.row(column) / size(column)).cast<Complex>();
    ++column;
  }
  return projection;
}

}  // namespace pennon::decomposition

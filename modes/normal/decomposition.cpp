#include "modes/normal/decomposition.hpp"

#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cassert>
#include <cmath>

#include "common/errors.hpp"
#include "common/linear_algebra/svd.hpp"
#include "modes/normal/gauss_legendre.hpp"

namespace pennon::modes {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

double relative(double rest, double whole) {
  return whole > 0 ? std::sqrt(rest / whole) : 0;
}

int largest_wave(const NormalModes& family) {
  int largest = 0;
  for (const NormalMode& mode : family.modes) largest = std::max(largest, mode.n);
  return largest;
}

// Points over one period of the span and the chord, and the weights of the squared norm.
struct Grid {
  VectorXd x, y, weight;

  Grid(const NormalModes& family, int waves) {
    const int columns = family.gamma ? 2 * std::max(waves, largest_wave(family)) + 1 : 1;
    x = VectorXd::LinSpaced(columns, 0, columns - 1) * (family.gamma.value_or(0) / columns);
    const std::vector<QuadraturePoint> points = gauss_legendre(family.panels);
    y.resize(static_cast<Eigen::Index>(points.size()));
    weight.resize(y.size());
    for (Eigen::Index i = 0; i < y.size(); ++i) {
      const QuadraturePoint& point = points[static_cast<std::size_t>(i)];
      y[i] = point.y;
      weight[i] = point.weight * family.weight(point.y);
    }
  }

  // The mean over x of the integral over y of w zeta^2.
  double squared_norm(const MatrixXd& zeta) const {
    return weight.dot(zeta.rowwise().squaredNorm()) / static_cast<double>(x.size());
  }
};

// The columns of the least-squares problem: for each mode its cosine and, for n > 0, its sine.
struct Column {
  const NormalMode* mode;
  bool is_sine;

  double operator()(const Sample& at) const {
    const double phase = mode->k_x * at.x;
    return mode->shape(at.y) / std::sqrt(mode->norm_squared) *
           (is_sine ? std::sin(phase) : std::cos(phase));
  }
};

std::vector<Column> columns_of(const NormalModes& family) {
  std::vector<Column> columns;
  for (const NormalMode& mode : family.modes) {
    columns.push_back({&mode, false});
    if (mode.n > 0) columns.push_back({&mode, true});
  }
  return columns;
}

void require_determined(const Eigen::ColPivHouseholderQR<MatrixXd>& factors,
                        const std::string& where) {
  if (factors.rank() == factors.cols()) return;
  throw InputError(where,
                   fmt::format("the {} samples determine only {} of {} amplitudes: some sum of "
                               "modes vanishes at all of them; spread them over the chord and "
                               "over one period of the span, or take fewer modes",
                               factors.rows(), factors.rank(), factors.cols()));
}

double condition_number(const Eigen::ColPivHouseholderQR<MatrixXd>& factors) {
  const Eigen::Index count = factors.cols();
  const MatrixXd R = factors.matrixR().topRows(count).triangularView<Eigen::Upper>();
  const VectorXd singular = singular_values(R);
  return singular[0] / singular[count - 1];
}

}  // namespace

Decomposition decompose(const NormalModes& family, const Displacement& zeta, int waves) {
  assert(waves >= 0);
  const Grid grid(family, waves);
  MatrixXd rest(grid.y.size(), grid.x.size());
  for (Eigen::Index j = 0; j < grid.x.size(); ++j)
    for (Eigen::Index i = 0; i < grid.y.size(); ++i) rest(i, j) = zeta(grid.x[j], grid.y[i]);
  const double whole = grid.squared_norm(rest);
  Decomposition result{{}, 0, std::nullopt};
  for (const NormalMode& mode : family.modes) {
    const VectorXd Y = grid.y.unaryExpr(mode.shape);
    const VectorXd cosine = (mode.k_x * grid.x).array().cos();
    const VectorXd sine = (mode.k_x * grid.x).array().sin();
    const double periods = (mode.n > 0 ? 2.0 : 1.0) / static_cast<double>(grid.x.size());
    const VectorXd along_span =
        rest.transpose() * grid.weight.cwiseProduct(Y) * (periods / mode.norm_squared);
    const double A = along_span.dot(cosine);
    const double B = along_span.dot(sine);
    result.amplitudes.push_back({mode.n, mode.m, A, B});
    rest -= Y * (A * cosine + B * sine).transpose();
  }
  result.truncation_error = relative(grid.squared_norm(rest), whole);
  return result;
}

Decomposition decompose(const NormalModes& family, std::span<const Sample> samples,
                        const std::string& where) {
  const std::vector<Column> columns = columns_of(family);
  const auto unknowns = static_cast<Eigen::Index>(columns.size());
  if (samples.size() < columns.size())
    throw InputError(where,
                     fmt::format("has {} samples for {} unknown amplitudes; give at least as "
                                 "many, or take fewer modes",
                                 samples.size(), unknowns));
  MatrixXd matrix(samples.size(), unknowns);
  VectorXd zeta(samples.size());
  for (Eigen::Index i = 0; i < zeta.size(); ++i) {
    const Sample& sample = samples[static_cast<std::size_t>(i)];
    const double weight = std::sqrt(family.weight(sample.y));
    zeta[i] = weight * sample.zeta;
    for (Eigen::Index j = 0; j < unknowns; ++j)
      matrix(i, j) = weight * columns[static_cast<std::size_t>(j)](sample);
  }
  const Eigen::ColPivHouseholderQR<MatrixXd> factors(matrix);
  require_determined(factors, where);
  const VectorXd solution = factors.solve(zeta);
  const VectorXd rest = zeta - matrix * solution;
  Decomposition result{{},
                       relative(rest.squaredNorm(), zeta.squaredNorm()),
                       Fit{samples.size(), unknowns, condition_number(factors)}};
  for (Eigen::Index j = 0; j < unknowns; ++j) {
    const auto& [mode, is_sine] = columns[static_cast<std::size_t>(j)];
    const double amplitude = solution[j] / std::sqrt(mode->norm_squared);
    if (is_sine)
      result.amplitudes.back().B = amplitude;
    else
      result.amplitudes.push_back({mode->n, mode->m, amplitude, 0});
  }
  return result;
}

double displacement(const NormalModes& family, std::span<const Amplitude> amplitudes, double x,
                    double y) {
  assert(amplitudes.size() == family.modes.size());
  double zeta = 0;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const NormalMode& mode = family.modes[i];
    const double phase = mode.k_x * x;
    zeta += mode.shape(y) * (amplitudes[i].A * std::cos(phase) + amplitudes[i].B * std::sin(phase));
  }
  return zeta;
}

}  // namespace pennon::modes

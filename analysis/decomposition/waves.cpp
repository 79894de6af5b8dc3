#include "analysis/decomposition/waves.hpp"

#include <fftw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "analysis/decomposition/welch.hpp"
#include "common/errors.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Complexes = std::vector<Complex>;
using Plan = std::unique_ptr<std::remove_pointer_t<fftw_plan>, decltype(&fftw_destroy_plan)>;

// Root mean squares of the parts with omega > 0 and omega < 0 of exp(-i omega t), under a window.
void set_parts(SpanwiseWaveParts& wave) {
  const std::size_t M = wave.zeta.size();
  const auto length = static_cast<Eigen::Index>(M);
  const Eigen::VectorXd window = welch_blocks(length, length, 0, Taper::hann).window;
  // The mean under the window: a wave of other than whole periods has next to none.
  Complex mean = 0;
  for (std::size_t m = 0; m < M; ++m)
    mean += wave.zeta[m] * window(static_cast<Eigen::Index>(m)) / window.sum();
  Complexes values(M);
  for (std::size_t m = 0; m < M; ++m)
    values[m] = (wave.zeta[m] - mean) * window(static_cast<Eigen::Index>(m));
  auto* data = reinterpret_cast<fftw_complex*>(values.data());
  const Plan plan(fftw_plan_dft_1d(static_cast<int>(M), data, data, FFTW_FORWARD, FFTW_ESTIMATE),
                  fftw_destroy_plan);
  fftw_execute(plan.get());
  double along = 0, against = 0;
  // Forward coefficients k > 0 belong to exp(+i omega t).
  for (std::size_t k = 1; k < M; ++k) (2 * k < M ? against : along) += std::norm(values[k]);
  const auto squared = static_cast<double>(M) * static_cast<double>(M);
  double slow = 0;
  for (std::size_t k = 1; k < M; ++k) slow += std::min(k, M - k) < 3 ? std::norm(values[k]) : 0;
  wave.is_short = slow > 0.5 * (along + against);
  wave.along = std::sqrt(along / squared);
  wave.against = std::sqrt(against / squared);
}

}  // namespace

std::vector<SpanwiseWaveParts> waves(const Bands<double>& bands, double y) {
  const Layout& layout = bands.layout();
  if (layout.y.empty())
    throw InputError("[decompose]", "decompose.method = \"waves\" is of a flag, and " +
                                        layout.name + " holds none (z with y, or a run)");
  if (bands.snapshots() < 4)
    throw InputError(
        layout.name,
        fmt::format("has {} snapshots; waves need 4 to tell in which sense they travel",
                    bands.snapshots()));
  const std::size_t stations = layout.stations ? layout.stations->count : 1;
  const std::size_t of_station = layout.points / stations;
  const auto nearest = static_cast<std::size_t>(
      std::min_element(layout.y.begin(), layout.y.begin() + static_cast<std::ptrdiff_t>(of_station),
                       [&](double a, double b) { return std::abs(a - y) < std::abs(b - y); }) -
      layout.y.begin());
  const auto M = static_cast<std::size_t>(bands.snapshots());
  std::vector<SpanwiseWaveParts> found(stations / 2 + 1);
  for (std::size_t n = 0; n < found.size(); ++n) {
    found[n].n = n;
    found[n].k_x =
        layout.stations ? 2 * std::numbers::pi * static_cast<double>(n) / layout.stations->span : 0;
    found[n].zeta.assign(M, 0);
  }
  const auto add = [&](std::size_t station, const Eigen::RowVectorXd& z) {
    for (SpanwiseWaveParts& wave : found) {
      const bool is_alone = wave.n == 0 || 2 * wave.n == stations;
      const double turns =
          static_cast<double>(wave.n * station % stations) / static_cast<double>(stations);
      const Complex factor = std::polar((is_alone ? 1.0 : 2.0) / static_cast<double>(stations),
                                        -2 * std::numbers::pi * turns);
      for (std::size_t m = 0; m < M; ++m) wave.zeta[m] += factor * z(static_cast<Eigen::Index>(m));
    }
  };
  bands.for_each(0, 0, [&](const BandOfData<double>& data) {
    for (std::size_t i = 0; i < data.band.count; ++i) {
      const std::size_t point = data.band.first + i;
      if (point % of_station == nearest)
        add(point / of_station, data.A.row(static_cast<Eigen::Index>(i)));
    }
  });
  for (SpanwiseWaveParts& wave : found)
    ranks::sum({reinterpret_cast<double*>(wave.zeta.data()), 2 * M});
  for (SpanwiseWaveParts& wave : found) set_parts(wave);
  return found;
}

}  // namespace pennon::decomposition

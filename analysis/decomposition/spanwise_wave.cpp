#include "analysis/decomposition/spanwise_wave.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::decomposition {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

Layout layout_of_wave(const Layout& whole, std::int64_t n) {
  Layout layout = whole;
  const std::size_t stations = whole.stations->count;
  layout.points = whole.points / stations;
  layout.is_complex = true;
  layout.stations.reset();
  layout.quantity = fmt::format("{}: wave {} along the span", whole.quantity, n);
  layout.y.resize(std::min(layout.y.size(), layout.points));
  // Without x, which comes first.
  layout.coordinates.clear();
  layout.dimensions = whole.dimensions > 1 ? whole.dimensions - 1 : 0;
  if (layout.dimensions > 0)
    for (std::size_t p = 0; p < layout.points; ++p)
      for (std::size_t d = 1; d < whole.dimensions; ++d)
        layout.coordinates.push_back(whole.coordinates[p * whole.dimensions + d]);
  return layout;
}

class SpanwiseWave final : public Snapshots {
 public:
  SpanwiseWave(std::unique_ptr<Snapshots> whole, std::int64_t n)
      : Snapshots(layout_of_wave(whole->layout(), n)), whole_(std::move(whole)), n_(n) {}

  void read(Band band, Eigen::MatrixXd& values) const override {
    Eigen::MatrixXcd complex;
    read_complex(band, complex);
    values = complex.real();
  }

  void read_complex(Band band, Eigen::MatrixXcd& sum) const override {
    const std::size_t stations = whole_->layout().stations->count;
    sum.setZero(static_cast<Index>(band.count), static_cast<Index>(layout().t.size()));
    Eigen::MatrixXd of_station;
    for_each_part(band, [&](std::size_t row, std::size_t station, Band part) {
      const auto turns = static_cast<double>(static_cast<std::size_t>(n_) * station % stations) /
                         static_cast<double>(stations);
      const Complex factor =
          std::polar(1 / static_cast<double>(stations), -2 * std::numbers::pi * turns);
      whole_->read(part, of_station);
      sum.middleRows(static_cast<Index>(row), of_station.rows()) += factor * of_station;
    });
  }

  Eigen::MatrixXd weights(Band band) const override {
    const std::size_t stations = whole_->layout().stations->count;
    const bool is_alone = n_ == 0 || static_cast<std::size_t>(2 * n_) == stations;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(static_cast<Index>(band.count), 1);
    for_each_part(band, [&](std::size_t row, std::size_t, Band part) {
      sum.middleRows(static_cast<Index>(row), static_cast<Index>(part.count)) +=
          whole_->weights(part);
    });
    return (is_alone ? 1 : 2) * sum;
  }

 private:
  // The parts of a band that lie in one component each, at each station: from which row of the
  // band, and where in the whole.
  template <class Function>
  void for_each_part(Band band, const Function& function) const {
    const std::size_t points = layout().points, all_points = whole_->layout().points;
    for (std::size_t value = band.first; value < band.first + band.count;) {
      const std::size_t component = value / points, point = value % points;
      const std::size_t count = std::min(points - point, band.first + band.count - value);
      for (std::size_t station = 0; station < all_points / points; ++station)
        function(value - band.first, station,
                 Band{component * all_points + station * points + point, count});
      value += count;
    }
  }

  std::unique_ptr<Snapshots> whole_;
  std::int64_t n_;
};

// Waves are orthogonal only where each station weighs the same.
void expect_equal_stations(const Snapshots& whole) {
  constexpr double slack = 1e-9;
  const Layout& layout = whole.layout();
  const auto points = static_cast<Index>(layout.points / layout.stations->count);
  const Eigen::VectorXd weights = whole.weights({0, layout.points}).col(0);
  const auto of_first = weights.head(points);
  for (Index station = 1; station < static_cast<Index>(layout.stations->count); ++station) {
    const double difference =
        (weights.segment(station * points, points) - of_first).cwiseAbs().maxCoeff();
    if (!(difference <= slack * of_first.maxCoeff()))
      throw InputError(layout.name,
                       fmt::format("has other weights at station {} along the span than at "
                                   "the first; decompose.wave needs the same at each",
                                   station));
  }
}

}  // namespace

std::unique_ptr<Snapshots> spanwise_wave(std::unique_ptr<Snapshots> whole, std::int64_t n) {
  const Layout& layout = whole->layout();
  const std::string key = "[decompose]";
  if (!layout.stations)
    throw InputError(
        key, fmt::format("decompose.wave = {} needs a span, and {} has none: stations x with "
                         "the attribute span",
                         n, layout.name));
  if (layout.is_complex)
    throw InputError(key, "decompose.wave is of real data, and these are complex");
  if (layout.has_changing_weights)
    throw InputError(key, "decompose.wave needs weights that do not change with time");
  const auto stations = static_cast<std::int64_t>(layout.stations->count);
  if (2 * n > stations)
    throw InputError(key, fmt::format("decompose.wave = {} cannot be told from a longer wave by {} "
                                      "stations; they resolve waves up to {}",
                                      n, stations, stations / 2));
  expect_equal_stations(*whole);
  return std::make_unique<SpanwiseWave>(std::move(whole), n);
}

}  // namespace pennon::decomposition

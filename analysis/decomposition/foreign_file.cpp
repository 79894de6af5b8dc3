#include "analysis/decomposition/foreign_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/decomposition/pieces.hpp"
#include "common/errors.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::decomposition {
namespace {

using Eigen::MatrixXd;
using hdf5::any;

// Stations x along a span, which must be equally spaced from 0 on.
Stations stations_of(const hdf5::Reader& file) {
  constexpr double slack = 1e-6;  // of the span: what single precision leaves
  const std::vector<double> x = file.list("/x");
  const Stations stations{file.number("/x", "span"), x.size()};
  if (!(stations.span > 0))
    file.fail(fmt::format("has {} for the attribute span of /x; the period must be above 0",
                          stations.span));
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double expected = stations.span * static_cast<double>(i) / static_cast<double>(x.size());
    if (!(std::abs(x[i] - expected) <= slack * stations.span))
      file.fail(
          fmt::format("has x[{}] = {} for {} stations along a span of {}; they must be equally "
                      "spaced from 0, without its end: {} is right",
                      i, x[i], x.size(), stations.span, expected));
  }
  return stations;
}

std::vector<std::string> component_names(const hdf5::Reader& file, std::size_t count) {
  std::vector<std::string> names = file.texts("/q", "names");
  if (names.empty())
    for (std::size_t c = 0; c < count; ++c)
      names.push_back(count == 1 ? "q" : fmt::format("q_{}", c));
  if (names.size() != count)
    file.fail(fmt::format("has {} names in the attribute names of /q, which has {} component{}",
                          names.size(), count, count == 1 ? "" : "s"));
  return names;
}

// z or q as an array with the time first, then perhaps a component, then the points.
class HdfSnapshots final : public Snapshots {
 public:
  HdfSnapshots(hdf5::Reader file, std::string array, Layout layout, Selection taken,
               std::vector<double> constant_weights)
      : Snapshots(std::move(layout)),
        file_(std::move(file)),
        array_(std::move(array)),
        shape_(file_.shape(array_)),
        taken_(taken),
        constant_weights_(std::move(constant_weights)) {}

  void read(Band band, MatrixXd& values) const override { read_as(band, values); }
  void read_complex(Band band, Eigen::MatrixXcd& values) const override {
    if (!layout().is_complex) return Snapshots::read_complex(band, values);
    read_as(band, values);
  }

  MatrixXd weights(Band band) const override {
    const bool changes = layout().has_changing_weights;
    MatrixXd found(static_cast<Eigen::Index>(band.count), changes ? columns() : 1);
    for_each_part(band, [&](std::size_t, std::size_t point, std::size_t row, std::size_t count) {
      auto rows =
          found.middleRows(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(count));
      if (!changes) {
        rows = Eigen::Map<const Eigen::VectorXd>(constant_weights_.data() + point,
                                                 static_cast<Eigen::Index>(count));
        return;
      }
      MatrixXd of_part(rows.rows(), columns());
      file_.read_part("/weight", {taken_.first, point}, {taken_.count, count},
                      std::span(of_part.data(), static_cast<std::size_t>(of_part.size())));
      expect_weights(of_part, point);
      rows = of_part;
    });
    return found;
  }

 private:
  Eigen::Index columns() const { return static_cast<Eigen::Index>(taken_.count); }

  // The parts of a band that lie in one component each.
  template <class Function>
  void for_each_part(Band band, const Function& function) const {
    const std::size_t points = layout().points;
    for (std::size_t value = band.first; value < band.first + band.count;) {
      const std::size_t component = value / points, point = value % points;
      const std::size_t count = std::min(points - point, band.first + band.count - value);
      function(component, point, value - band.first, count);
      value += count;
    }
  }

  template <class Scalar>
  void read_as(Band band, DenseMatrix<Scalar>& values) const {
    values.resize(static_cast<Eigen::Index>(band.count), columns());
    for_each_part(
        band, [&](std::size_t component, std::size_t point, std::size_t row, std::size_t count) {
          if (count == band.count) return read_points(component, point, count, values);
          DenseMatrix<Scalar> of_part(static_cast<Eigen::Index>(count), columns());
          read_points(component, point, count, of_part);
          values.middleRows(static_cast<Eigen::Index>(row), of_part.rows()) = of_part;
        });
  }

  // Points of a component at all times: HDF5 leaves them as the columns of a matrix.
  template <class Scalar>
  void read_points(std::size_t component, std::size_t point, std::size_t count,
                   DenseMatrix<Scalar>& values) const {
    const std::span<Scalar> all(values.data(), static_cast<std::size_t>(values.size()));
    if (array_ == "/q") {
      hdf5::Shape start = {taken_.first, point}, counts = {taken_.count, count};
      if (shape_.size() == 3) {
        start.insert(start.begin() + 1, component);
        counts.insert(counts.begin() + 1, 1);
      }
      file_.read_part(array_, start, counts, all);
    } else if (shape_.size() == 2) {
      file_.read_part(array_, {taken_.first, point}, {taken_.count, count}, all);
    } else {
      read_stations(point, count, values);
    }
  }

  // Points of z (M, n_x, n_y), from whole stations.
  template <class Scalar>
  void read_stations(std::size_t point, std::size_t count, DenseMatrix<Scalar>& values) const {
    const std::size_t n_y = shape_[2], first = point / n_y, end = (point + count - 1) / n_y + 1;
    DenseMatrix<Scalar> whole(static_cast<Eigen::Index>((end - first) * n_y), columns());
    file_.read_part(array_, {taken_.first, first, 0}, {taken_.count, end - first, n_y},
                    std::span(whole.data(), static_cast<std::size_t>(whole.size())));
    values = whole.middleRows(static_cast<Eigen::Index>(point - first * n_y),
                              static_cast<Eigen::Index>(count));
  }

  void expect_weights(const MatrixXd& weights, std::size_t point) const {
    Eigen::Index row = 0, column = 0;
    const double least = weights.minCoeff(&row, &column);
    if (weights.allFinite() && least >= 0) return;
    file_.fail(
        fmt::format("has {} in /weight for the points from {} on; weights must be finite and 0 "
                    "or more",
                    least, point));
  }

  hdf5::Reader file_;
  std::string array_;
  hdf5::Shape shape_;
  Selection taken_;
  std::vector<double> constant_weights_;
};

void expect_snapshots(const hdf5::Reader& file, const std::string& array, const hdf5::Shape& shape,
                      std::size_t times) {
  if (shape.empty() || shape[0] != times)
    file.fail(
        fmt::format("has {} times in /t and {} snapshots in {}; there must be one snapshot a "
                    "time, with the time as the first index",
                    times, shape.empty() ? 0 : shape[0], array));
}

std::unique_ptr<Snapshots> open_flag(hdf5::Reader file, const std::vector<double>& t,
                                     const Window& window) {
  const hdf5::Shape shape = file.shape("/z");
  expect_snapshots(file, "/z", shape, t.size());
  if (shape.size() != 2 && shape.size() != 3)
    file.fail(
        fmt::format("has an array /z of {} indices; (t, y) or (t, x, y) is needed", shape.size()));
  if (file.is_complex("/z")) file.fail("has complex numbers in /z; a shape is real");
  const std::vector<double> y = file.list("/y", shape.back());
  if (!std::ranges::is_sorted(y, std::less_equal()))
    file.fail("has y that does not increase in /y");
  const Selection taken = selected(t, window, file.path().string());
  Layout layout{.name = file.path().string(),
                .quantity = "z of the flag, in L",
                .t = taken_of(t, taken),
                .points = shape.size() == 3 ? shape[1] * shape[2] : shape[1],
                .components = {"z"}};
  if (shape.size() == 3) {
    layout.stations = stations_of(file);
    if (layout.stations->count != shape[1])
      file.fail(
          fmt::format("has {} stations in /x and {} in /z", layout.stations->count, shape[1]));
  }
  std::vector<double> weights = flag_pieces(y, layout.stations);
  place_nodes(y, layout);
  return std::make_unique<HdfSnapshots>(std::move(file), "/z", std::move(layout), taken,
                                        std::move(weights));
}

// The weights of q; nothing where they change with time, and are read with the values.
std::vector<double> weights_of_field(const hdf5::Reader& file, std::size_t times, Layout& layout) {
  if (!file.contains("/weight")) return std::vector<double>(layout.points, 1.0);
  const hdf5::Shape shape = file.shape("/weight");
  layout.has_changing_weights = shape.size() == 2;
  if (layout.has_changing_weights) {
    (void)file.shape("/weight", {times, layout.points});
    return {};
  }
  std::vector<double> weights = file.list("/weight", layout.points);
  const auto bad =
      std::ranges::find_if_not(weights, [](double w) { return w >= 0 && std::isfinite(w); });
  if (bad != weights.end())
    file.fail(fmt::format("has {} at index {} of /weight; weights must be finite and 0 or more",
                          *bad, bad - weights.begin()));
  if (std::ranges::none_of(weights, [](double w) { return w > 0; }))
    file.fail("has no weight above 0 in /weight");
  return weights;
}

std::unique_ptr<Snapshots> open_field(hdf5::Reader file, const std::vector<double>& t,
                                      const Window& window) {
  const hdf5::Shape shape = file.shape("/q");
  expect_snapshots(file, "/q", shape, t.size());
  if (shape.size() != 2 && shape.size() != 3)
    file.fail(
        fmt::format("has an array /q of {} indices; (t, point) or (t, component, point) is "
                    "needed",
                    shape.size()));
  const Selection taken = selected(t, window, file.path().string());
  Layout layout{.name = file.path().string(),
                .quantity = "q",
                .t = taken_of(t, taken),
                .points = shape.back(),
                .components = component_names(file, shape.size() == 3 ? shape[1] : 1),
                .is_complex = file.is_complex("/q")};
  if (layout.points == 0 || layout.components.empty()) file.fail("has no values in /q");
  if (file.contains("/x")) {
    layout.stations = stations_of(file);
    if (layout.points % layout.stations->count != 0)
      file.fail(fmt::format("has {} points in /q, no multiple of the {} stations in /x",
                            layout.points, layout.stations->count));
  }
  if (file.contains("/coordinates")) {
    hdf5::Array coordinates = file.read("/coordinates", {layout.points, any});
    layout.dimensions = coordinates.shape[1];
    layout.coordinates = std::move(coordinates.values);
    file.expect_finite("/coordinates", layout.coordinates);
  }
  std::vector<double> weights = weights_of_field(file, t.size(), layout);
  return std::make_unique<HdfSnapshots>(std::move(file), "/q", std::move(layout), taken,
                                        std::move(weights));
}

// A few signals, held in memory.
class Signals final : public Snapshots {
 public:
  Signals(Layout layout, MatrixXd values)
      : Snapshots(std::move(layout)), values_(std::move(values)) {}

  void read(Band band, MatrixXd& values) const override {
    values = values_.middleRows(static_cast<Eigen::Index>(band.first),
                                static_cast<Eigen::Index>(band.count));
  }
  MatrixXd weights(Band band) const override {
    return MatrixXd::Ones(static_cast<Eigen::Index>(band.count), 1);
  }

 private:
  MatrixXd values_;
};

}  // namespace

std::unique_ptr<Snapshots> open_foreign_file(const std::filesystem::path& path, Foreign which,
                                             const Window& window) {
  hdf5::Reader file(path);
  const bool has_flag = file.contains("/z"), has_field = file.contains("/q");
  if (!has_flag && !has_field)
    file.fail(
        "has neither z, the shape of a flag, nor q, snapshots of anything; docs/decomposition.md "
        "says how they lie in a file");
  const std::vector<double> t = file.list("/t", any);
  const bool takes_flag = has_flag && (which == Foreign::flag || !has_field);
  return takes_flag ? open_flag(std::move(file), t, window)
                    : open_field(std::move(file), t, window);
}

std::unique_ptr<Snapshots> open_signals(const std::filesystem::path& path, const Window& window) {
  const CsvTable table(path);
  const std::vector<std::string>& names = table.names();
  if (names.front() != "t")
    throw InputError(path.string(),
                     fmt::format("has the first column {}; it must be t, the time", names.front()));
  if (names.size() < 2) throw InputError(path.string(), "has no column beside t");
  const std::vector<double> t = table.numbers("t");
  const Selection taken = selected(t, window, path.string());
  Layout layout{.name = path.string(),
                .quantity = "signals",
                .t = taken_of(t, taken),
                .points = 1,
                .components = {names.begin() + 1, names.end()}};
  MatrixXd values(static_cast<Eigen::Index>(names.size() - 1),
                  static_cast<Eigen::Index>(taken.count));
  for (std::size_t c = 1; c < names.size(); ++c) {
    const std::vector<double> column = taken_of(table.numbers(names[c]), taken);
    values.row(static_cast<Eigen::Index>(c) - 1) =
        Eigen::Map<const Eigen::RowVectorXd>(column.data(), values.cols());
  }
  return std::make_unique<Signals>(std::move(layout), std::move(values));
}

}  // namespace pennon::decomposition

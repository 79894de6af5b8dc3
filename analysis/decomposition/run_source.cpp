#include "analysis/decomposition/run_source.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/decomposition/pieces.hpp"
#include "common/errors.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::decomposition {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using hdf5::any;

constexpr std::size_t dimensions = 3;

std::string shape_array(std::size_t shape) {
  return fmt::format("/position/{:06}", shape);
}

// The positions of a shape: stations x nodes x 3, without the station that closes a periodic span.
class FlagSnapshots final : public Snapshots {
 public:
  FlagSnapshots(hdf5::Reader file, Layout layout, Selection taken, std::vector<double> weights)
      : Snapshots(std::move(layout)),
        file_(std::move(file)),
        shape_(file_.shape(shape_array(taken.first))),
        taken_(taken),
        weights_(std::move(weights)) {}

  void read(Band band, MatrixXd& found) const override {
    found.resize(static_cast<Index>(band.count), static_cast<Index>(taken_.count));
    for (std::size_t m = 0; m < taken_.count; ++m) {
      const hdf5::Array nodes = file_.read(shape_array(taken_.first + m), shape_);
      for (std::size_t i = 0; i < band.count; ++i)
        found(static_cast<Index>(i), static_cast<Index>(m)) =
            nodes.values[dimensions * (band.first + i) + 2];
    }
  }
  MatrixXd weights(Band band) const override {
    return Eigen::Map<const Eigen::VectorXd>(weights_.data() + band.first,
                                             static_cast<Index>(band.count));
  }

 private:
  hdf5::Reader file_;
  hdf5::Shape shape_;
  Selection taken_;
  std::vector<double> weights_;
};

// Lengths along the chord of a station's nodes, from 0 to 1.
std::vector<double> chord_of(const double* nodes, std::size_t count) {
  std::vector<double> s = {0};
  for (std::size_t j = 1; j < count; ++j) {
    const double* a = nodes + dimensions * (j - 1);
    const double* b = nodes + dimensions * j;
    s.push_back(s.back() + std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  for (double& length : s) length /= s.back();
  return s;
}

// Velocities at the cells of the fields, a file for each time.
class FluidSnapshots final : public Snapshots {
 public:
  FluidSnapshots(Layout layout, std::vector<std::filesystem::path> files, hdf5::Shape cells)
      : Snapshots(std::move(layout)), files_(std::move(files)), cells_(std::move(cells)) {}

  void read(Band band, MatrixXd& found) const override {
    found.resize(static_cast<Index>(band.count), static_cast<Index>(files_.size()));
    const std::size_t points = layout().points;
    for (std::size_t m = 0; m < files_.size(); ++m) {
      const hdf5::Reader file(files_[m]);
      for (std::size_t c = 0; c < layout().components.size(); ++c) {
        const std::size_t begin = std::max(band.first, c * points);
        const std::size_t end = std::min(band.first + band.count, (c + 1) * points);
        if (begin >= end) continue;
        const std::vector<double> values = file.read("/" + layout().components[c], cells_).values;
        for (std::size_t i = begin; i < end; ++i)
          found(static_cast<Index>(i - band.first), static_cast<Index>(m)) = values[i - c * points];
      }
    }
  }

  MatrixXd weights(Band band) const override {
    MatrixXd found(static_cast<Index>(band.count), static_cast<Index>(files_.size()));
    for (std::size_t m = 0; m < files_.size(); ++m) {
      const std::vector<double> volumes = cell_volumes(hdf5::Reader(files_[m]));
      for (std::size_t i = 0; i < band.count; ++i)
        found(static_cast<Index>(i), static_cast<Index>(m)) =
            volumes[(band.first + i) % layout().points];
    }
    return found;
  }

 private:
  // Of the cells between corners [plane][rho][theta]: the area in the plane times the distance to
  // the next plane; in two dimensions the area. An O-grid's cells do not fold, so the area is
  // positive.
  std::vector<double> cell_volumes(const hdf5::Reader& file) const {
    hdf5::Shape corners = cells_;
    for (hsize_t& extent : corners) ++extent;
    corners.push_back(dimensions);
    const std::vector<double> points = file.read("/points", corners).values;
    const std::size_t axes = cells_.size(), n_theta = cells_[axes - 1], n_rho = cells_[axes - 2];
    const std::size_t planes = axes == 3 ? cells_[0] : 1, row = n_theta + 1,
                      plane = (n_rho + 1) * row;
    const auto at = [&](std::size_t p, std::size_t j, std::size_t k) {
      return points.data() + dimensions * (p * plane + j * row + k);
    };
    std::vector<double> volumes;
    for (std::size_t p = 0; p < planes; ++p)
      for (std::size_t j = 0; j < n_rho; ++j)
        for (std::size_t k = 0; k < n_theta; ++k) {
          const double* a = at(p, j, k);
          const double* b = at(p, j, k + 1);
          const double* c = at(p, j + 1, k + 1);
          const double* d = at(p, j + 1, k);
          const double area =
              std::abs((c[1] - a[1]) * (d[2] - b[2]) - (d[1] - b[1]) * (c[2] - a[2])) / 2;
          volumes.push_back(area * (axes == 3 ? at(p + 1, j, k)[0] - a[0] : 1));
        }
    return volumes;
  }

  std::vector<std::filesystem::path> files_;
  hdf5::Shape cells_;
};

std::vector<std::filesystem::path> field_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("fields_") && name.ends_with(".h5")) files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace

std::unique_ptr<Snapshots> open_run_flag(const std::filesystem::path& folder, double mu,
                                         const Window& window) {
  const std::filesystem::path path = folder / "shapes.h5";
  if (!std::filesystem::exists(path))
    throw InputError(folder.string(),
                     "has no shapes of the flag (shapes.h5); a run keeps them with "
                     "dns.output.shape_interval");
  hdf5::Reader file(path);
  const std::vector<double> t = file.list("/shape_times");
  const Selection taken = selected(t, window, path.string());
  const hdf5::Array first = file.read(shape_array(taken.first), {any, any, dimensions});
  const std::size_t rows = first.shape[0], columns = first.shape[1];
  if (columns < 2) file.fail("has shapes of one node; a chord has two at least");
  const std::vector<double> y = chord_of(first.values.data(), columns);
  Layout layout{.name = path.string(),
                .quantity = "z of the flag, in L",
                .t = taken_of(t, taken),
                .points = columns,
                .components = {"z"}};
  if (rows > 2) {
    const std::size_t stations = rows - 1;
    layout.points *= stations;
    layout.stations =
        Stations{first.values[dimensions * columns * stations] - first.values[0], stations};
    if (!(layout.stations->span > 0))
      file.fail("has shapes whose last station is not one span behind the first");
  }
  place_nodes(y, layout);
  std::vector<double> weights = flag_pieces(y, layout.stations);
  for (double& weight : weights) weight *= mu;
  return std::make_unique<FlagSnapshots>(std::move(file), std::move(layout), taken,
                                         std::move(weights));
}

std::unique_ptr<Snapshots> open_run_fluid(const std::filesystem::path& folder,
                                          const Window& window) {
  std::vector<std::filesystem::path> files = field_files(folder);
  if (files.empty())
    throw InputError(folder.string(),
                     "has no fields of the fluid (fields_*.h5); a run keeps them with "
                     "dns.output.field_interval");
  std::vector<double> t;
  t.reserve(files.size());
  for (const std::filesystem::path& path : files) t.push_back(hdf5::Reader(path).number("/", "t"));
  const Selection taken = selected(t, window, folder.string());
  files.erase(files.begin(), files.begin() + static_cast<std::ptrdiff_t>(taken.first));
  files.resize(taken.count);
  const hdf5::Reader file(files.front());
  hdf5::Shape cells = file.shape("/v");
  if (cells.size() != 2 && cells.size() != 3)
    file.fail(fmt::format("has an array /v of {} indices; fields have two or three", cells.size()));
  Layout layout{.name = folder.string(),
                .quantity = "velocity of the fluid, in V",
                .t = taken_of(t, taken),
                .points = hdf5::count(cells),
                .components = {"v", "w"},
                .has_changing_weights = true};
  if (cells.size() == 3) {
    layout.components.insert(layout.components.begin(), "u");
    layout.stations = Stations{file.number("/", "span"), cells[0]};
  }
  return std::make_unique<FluidSnapshots>(std::move(layout), std::move(files), std::move(cells));
}

}  // namespace pennon::decomposition

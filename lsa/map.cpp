#include "lsa/map.hpp"

#include <omp.h>

#include <algorithm>
#include <limits>
#include <map>
#include <memory>
#include <utility>

#include "common/interrupt.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "lsa/added_mass.hpp"
#include "lsa/axis_attributes.hpp"
#include "lsa/batch.hpp"
#include "lsa/outcome_points.hpp"
#include "lsa/quantity.hpp"

namespace pennon::lsa {
namespace {

constexpr std::size_t block_bytes = 64'000'000;
constexpr std::size_t most_nodes_traced = 1001;  // along an axis, for the neutral curve
const char* const interrupted = "the map was not written; run the same command again";

// The added mass `minami`, which costs milliseconds: computed once for each (k_x, k_y) that occurs.
class AddedMassCache {
 public:
  explicit AddedMassCache(const Theory& theory) : theory_(theory) {}

  bool is_needed() const { return theory_.model.added_mass == AddedMass::minami; }
  double computed(double k_x, double k_y) {
    const auto [entry, is_new] = known_.try_emplace({k_x, k_y}, 0.0);
    if (is_new) {
      stop_if_interrupted(interrupted);
      entry->second = added_mass(AddedMass::minami, theory_.minami, k_x, k_y);
    }
    return entry->second;
  }
  double known(double k_x, double k_y) const { return known_.at({k_x, k_y}); }

 private:
  const Theory& theory_;
  std::map<std::pair<double, double>, double> known_;
};

Point at(Point point, const MapAxes& axes, double x, double y) {
  set(point, axes.x_axis, x);
  set(point, axes.y_axis, y);
  return point;
}

// All that the map will ask for.
void fill(AddedMassCache& cache, const MapAxes& axes, const Point& point) {
  const auto matters = [](Axis a) { return a == Axis::k_x || a == Axis::gamma || a == Axis::k_y; };
  const std::size_t columns = matters(axes.x_axis) ? axes.x.size() : 1;
  const std::size_t rows = matters(axes.y_axis) ? axes.y.size() : 1;
  for (std::size_t j = 0; j < rows; ++j)
    for (std::size_t i = 0; i < columns; ++i) {
      const Point there = at(point, axes, axes.x[i], axes.y[j]);
      cache.computed(there.k_x, there.k_y);
    }
}

struct Work {
  PointBatch points;
  StabilityBatch results;
};

// Evaluates rows of a map into field-by-field buffers.
class Rows {
 public:
  Rows(const MapSettings& settings, const MapAxes& axes, const Point& point, const Theory& theory,
       const AddedMassCache& cache)
      : axes_(axes), point_(point), theory_(theory), cache_(cache) {
    for (const std::string& field : settings.fields) fields_.push_back(quantity(field).lanes);
  }

  /// Row j into buffers[field][row_in_block]; returns how many of its points are unstable.
  std::int64_t evaluate(std::size_t j, std::size_t row_in_block, Work& work,
                        std::vector<std::vector<double>>& buffers) const {
    const std::size_t width = axes_.x.size();
    std::int64_t unstable = 0;
    work.points.fill(point_);
    lanes(work.points, axes_.y_axis).fill(lane_value(axes_.y_axis, axes_.y[j]));
    Lanes& along_x = lanes(work.points, axes_.x_axis);
    for (std::size_t begin = 0; begin < width; begin += batch_size) {
      const std::size_t size = std::min(batch_size, width - begin);
      for (std::size_t i = 0; i < size; ++i)
        along_x[i] = lane_value(axes_.x_axis, axes_.x[begin + i]);
      if (cache_.is_needed())
        for (std::size_t i = 0; i < size; ++i)
          work.points.c_m[i] = cache_.known(work.points.k_x[i], work.points.k_y[i]);
      solve(theory_.model, work.points, size, work.results);
      for (std::size_t f = 0; f < fields_.size(); ++f)
        std::copy_n((work.results.*fields_[f]).begin(), size,
                    buffers[f].begin() + static_cast<std::ptrdiff_t>(row_in_block * width + begin));
      for (std::size_t i = 0; i < size; ++i) unstable += work.results.P[i] < 0 ? 1 : 0;
    }
    return unstable;
  }

 private:
  const MapAxes& axes_;
  const Point& point_;
  const Theory& theory_;
  const AddedMassCache& cache_;
  std::vector<Lanes StabilityBatch::*> fields_;
};

void declare_fields(hdf5::Writer& file, const MapSettings& settings, const MapAxes& axes) {
  for (const std::string& field : settings.fields) {
    const Quantity& q = quantity(field);
    file.declare("/fields/" + field, {axes.y.size(), axes.x.size()},
                 {{"name", q.name},
                  {"meaning", q.meaning},
                  {"symbol", q.symbol},
                  {"is_signed", std::int64_t(q.is_signed)}});
  }
}

// All rows, block by block; returns how many points are unstable.
std::int64_t write_fields(hdf5::Writer& file, const MapSettings& settings, const MapAxes& axes,
                          const Rows& rows, bool shows_progress) {
  const std::size_t width = axes.x.size();
  const std::size_t height = axes.y.size();
  const std::size_t row_bytes = settings.fields.size() * width * sizeof(double);
  const std::size_t block = std::clamp<std::size_t>(block_bytes / row_bytes, 1, height);
  std::vector<std::vector<double>> buffers(settings.fields.size(),
                                           std::vector<double>(block * width));
  Progress progress("map", static_cast<std::int64_t>(height), shows_progress);
  std::int64_t unstable = 0;
  // OMP_NUM_THREADS may ask for more than the system can start.
  const int threads = std::min(omp_get_max_threads(), omp_get_num_procs());
  for (std::size_t first = 0; first < height; first += block) {
    stop_if_interrupted(interrupted);
    const std::size_t count = std::min(block, height - first);
#pragma omp parallel num_threads(threads) reduction(+ : unstable)
    {
      const auto work = std::make_unique<Work>();
#pragma omp for schedule(static)
      for (std::size_t row = 0; row < count; ++row)
        unstable += rows.evaluate(first + row, row, *work, buffers);
    }
    for (std::size_t f = 0; f < settings.fields.size(); ++f)
      file.write_rows("/fields/" + settings.fields[f], first, count,
                      std::span(buffers[f]).first(count * width));
    progress.advance_to(static_cast<std::int64_t>(first + count));
  }
  return unstable;
}

// At most most_nodes_traced of the values, the first and the last among them.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = (values.size() + most_nodes_traced - 1) / most_nodes_traced;
  std::vector<double> kept;
  for (std::size_t i = 0; i < values.size(); i += stride) kept.push_back(values[i]);
  if (kept.back() != values.back()) kept.push_back(values.back());
  return kept;
}

void write_neutral(hdf5::Writer& file, const std::vector<Polyline>& lines, const MapAxes& axes,
                   const OutputFolder& folder) {
  CsvText table("the neutral curve P = 0: points to machine precision, numbered by piece",
                {"piece", name(axes.x_axis), name(axes.y_axis)});
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> x, y;
  for (std::size_t piece = 0; piece < lines.size(); ++piece) {
    for (std::size_t i = 0; i < lines[piece].x.size(); ++i) {
      x.push_back(lines[piece].x[i]);
      y.push_back(lines[piece].y[i]);
      table.row({static_cast<double>(piece + 1), x.back(), y.back()});
    }
    x.push_back(gap);
    y.push_back(gap);
  }
  if (!x.empty()) {
    file.write("/neutral/x", {x.size()}, x, {{"meaning", "P = 0; NaN between polylines"}});
    file.write("/neutral/y", {y.size()}, y);
  }
  write_file(folder / "neutral.csv", table.text());
}

}  // namespace

MapAxes axes_of(const MapSettings& settings) {
  std::vector<Axis> axes;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (settings.sweeps[i]) axes.push_back(static_cast<Axis>(i));
  if (axes[0] == Axis::mu) std::swap(axes[0], axes[1]);
  return {axes[0],
          axes[1],
          along(settings.sweeps, axes[0]).scale,
          along(settings.sweeps, axes[1]).scale,
          along(settings.sweeps, axes[0]).values(),
          along(settings.sweeps, axes[1]).values()};
}

MapSummary compute_map(const MapSettings& settings, const Point& point, const Theory& theory,
                       const std::vector<Outcome>& outcomes, const OutputFolder& folder,
                       bool shows_progress) {
  const MapAxes axes = axes_of(settings);
  MapSummary summary;
  summary.points = static_cast<std::int64_t>(axes.x.size() * axes.y.size());
  folder.require_space(
      static_cast<std::uintmax_t>(summary.points) * settings.fields.size() * sizeof(double),
      "the map");
  const StopWatch watch;
  hdf5::Writer file(folder / "map.h5");
  file.attributes({{"kind", "lsa_map"}, {"title", settings.title}, {"picture", settings.quantity}});
  file.write("/x", {axes.x.size()}, axes.x, attributes(axes.x_axis, axes.x_scale));
  file.write("/y", {axes.y.size()}, axes.y, attributes(axes.y_axis, axes.y_scale));
  declare_fields(file, settings, axes);
  AddedMassCache cache(theory);
  if (cache.is_needed()) fill(cache, axes, point);
  summary.unstable = write_fields(file, settings, axes, Rows(settings, axes, point, theory, cache),
                                  shows_progress);
  summary.wall_seconds = watch.seconds();
  if (settings.neutral) {
    const Model& model = theory.model;
    const auto g = [&](double x, double y) {
      const Point there = at(point, axes, x, y);
      if (!cache.is_needed()) return neutral_function(coefficients(there, theory));
      const double c_m = cache.computed(there.k_x, there.k_y);
      return neutral_function(
          coefficients(there, c_m, tension_times_sqrt_Re(model), model.bending, model.cross_flow));
    };
    summary.neutral = trace_neutral(g, thinned(axes.x), thinned(axes.y));
    write_neutral(file, summary.neutral, axes, folder);
  }
  write_outcome_points(file, outcomes, axes.x_axis, name(axes.y_axis), theory.model.cross_flow);
  file.finish();
  return summary;
}

}  // namespace pennon::lsa

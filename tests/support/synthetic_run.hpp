/// Histories with known answers, as a coupled run of pennon dns would leave them.
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "analysis/signal/run_history.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::test {

inline constexpr double two_pi = 2 * std::numbers::pi;

/// Times whose steps grow from a tenth of `dt` and then swing by a fifth about it.
inline std::vector<double> unequal_times(double to, double dt) {
  std::vector<double> t = {0};
  for (double step = dt / 10; t.back() < to; step = std::min(1.2 * step, dt))
    t.push_back(t.back() + step * (1 + 0.2 * std::sin(3.0 * static_cast<double>(t.size()))));
  return t;
}

/// Independent normal numbers, always the same.
class Noise {
 public:
  explicit Noise(double size) : normal_(0, size) {}
  double operator()() { return normal_(engine_); }

 private:
  std::mt19937 engine_{1};
  std::normal_distribution<double> normal_;
};

using Motion = std::function<double(double x, double t)>;

/// A run whose trailing edge moves as z(x, t) at `planes` stations; all columns are zero.
inline analysis::RunHistory synthetic_run(const std::vector<double>& t, double span,
                                          std::size_t planes, const Motion& z) {
  analysis::RunHistory run;
  run.span = span;
  run.t = t;
  for (const char* name :
       {"C_D", "C_L", "C_S", "kinetic", "dissipation", "wall_power", "outer_power", "energy_defect",
        "flag_kinetic", "bending", "stretch_2d", "stretch_3d", "gravity", "damping_dissipated",
        "fluid_work", "flag_defect"})
    run.columns[name].assign(t.size(), 0.0);
  run.columns["t"] = t;
  run.z.resize(planes);
  for (std::size_t m = 0; m < planes; ++m)
    for (const double time : t)
      run.z[m].push_back(z(span * static_cast<double>(m) / static_cast<double>(planes), time));
  return run;
}

/// Values of a column.
inline void set_column(analysis::RunHistory& run, const std::string& name,
                       const std::function<double(double t)>& value) {
  for (std::size_t row = 0; row < run.t.size(); ++row) run.columns[name][row] = value(run.t[row]);
}

/// A probe at (y, z) whose velocities v and w are v(x, t) and w(x, t).
inline void add_probe(analysis::RunHistory& run, double y, double z, const Motion& v,
                      const Motion& w) {
  analysis::ProbeHistory probe{y, z, {}, {}};
  for (std::size_t m = 0; m < run.planes(); ++m) {
    const double x = run.span * static_cast<double>(m) / static_cast<double>(run.planes());
    probe.v.emplace_back();
    probe.w.emplace_back();
    for (const double t : run.t) {
      probe.v.back().push_back(v(x, t));
      probe.w.back().push_back(w(x, t));
    }
  }
  run.probes.push_back(std::move(probe));
}

/// Writes history.h5 of a run in the form of dns/run/fluid_history.
inline void write_history(const analysis::RunHistory& run, const std::filesystem::path& file_name,
                          const std::string& kind = "coupled_history") {
  const hsize_t rows = run.t.size(), planes = run.planes();
  std::string names;
  std::vector<double> values;
  for (const auto& [name, column] : run.columns) names += (names.empty() ? "" : ",") + name;
  for (std::size_t row = 0; row < rows; ++row)
    for (const auto& [name, column] : run.columns) values.push_back(column[row]);
  std::vector<double> edge, velocities, y, z;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t m = 0; m < planes; ++m)
      edge.insert(edge.end(), {run.span * static_cast<double>(m) / static_cast<double>(planes), 1.0,
                               run.z[m][row]});
  for (std::size_t row = 0; row < rows; ++row)
    for (const analysis::ProbeHistory& probe : run.probes)
      for (std::size_t m = 0; m < planes; ++m)
        velocities.insert(velocities.end(), {probe.v[m][row], probe.w[m][row], 0.0, 0.0});
  for (const analysis::ProbeHistory& probe : run.probes) {
    y.push_back(probe.y);
    z.push_back(probe.z);
  }
  hdf5::Writer file(file_name);
  file.attributes({{"kind", kind}, {"span", run.span}});
  file.write("/history", {rows, run.columns.size()}, values, {{"columns", names}});
  file.write("/trailing_edge", {rows, planes, 3}, edge);
  if (!y.empty()) {
    file.write("/probes", {rows, y.size(), planes, 4}, velocities);
    file.write("/probe_y", {y.size()}, y);
    file.write("/probe_z", {z.size()}, z);
  }
  file.finish();
}

/// Writes shapes.h5 of a flag whose nodes are at z(x, y, t), `chord` of them along the chord.
inline void write_shapes(const std::vector<double>& times, double span, std::size_t planes,
                         std::size_t chord,
                         const std::function<double(double x, double y, double t)>& z,
                         const std::filesystem::path& file_name) {
  hdf5::Writer file(file_name);
  for (std::size_t s = 0; s < times.size(); ++s) {
    std::vector<double> positions;
    for (std::size_t m = 0; m <= planes; ++m)
      for (std::size_t j = 0; j < chord; ++j) {
        const double x = span * static_cast<double>(m) / static_cast<double>(planes);
        const double y = static_cast<double>(j) / static_cast<double>(chord - 1);
        positions.insert(positions.end(), {x, y, z(x, y, times[s])});
      }
    const std::string index = std::to_string(s);
    file.write("/position/" + std::string(6 - index.size(), '0') + index, {planes + 1, chord, 3},
               positions);
  }
  file.write("/shape_times", {times.size()}, times);
  file.finish();
}

}  // namespace pennon::test

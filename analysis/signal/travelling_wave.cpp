#include "analysis/signal/travelling_wave.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/signal/series.hpp"
#include "common/errors.hpp"
#include "common/io/hdf5.hpp"

namespace pennon::analysis {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;
// The part of the chord, at the trailing edge, over which the phase is followed.
constexpr double chord_share = 0.25;
// Shapes a period that show the sense in which a wave turns.
constexpr double fewest_shapes_a_period = 4;
// Probes are a pair along the stream if their z differ by less, in L.
constexpr double same_z = 1e-6;

Complexes between(const std::vector<double>& t, const Complexes& values, double from, double to,
                  std::vector<double>& times) {
  const Rows rows = rows_between(t, from, to);
  times.assign(t.begin() + static_cast<std::ptrdiff_t>(rows.begin),
               t.begin() + static_cast<std::ptrdiff_t>(rows.end));
  return {values.begin() + static_cast<std::ptrdiff_t>(rows.begin),
          values.begin() + static_cast<std::ptrdiff_t>(rows.end)};
}

Turning turning_in(const LimitCycle& cycle, const std::vector<double>& t,
                   const Complexes& component) {
  std::vector<double> times;
  const Complexes values = between(t, component, cycle.from, cycle.to, times);
  return turning_of(times, values, two_pi * cycle.f_s);
}

// The component with the largest mean square in the limit cycle.
std::size_t dominant_wave(const RunHistory& run, const std::vector<Complexes>& components,
                          const LimitCycle& cycle) {
  const Rows rows = rows_between(run.t, cycle.from, cycle.to);
  const auto energy = [&](const Complexes& component) {
    double sum = 0;
    for (std::size_t row = rows.begin; row < rows.end; ++row) sum += std::norm(component[row]);
    return sum;
  };
  return static_cast<std::size_t>(std::ranges::max_element(components, {}, energy) -
                                  components.begin());
}

// Component n of z along the chord at the kept times of a limit cycle.
struct ShapeWaves {
  std::vector<double> t;
  std::vector<double> y;              // mean, of the nodes near the trailing edge
  std::vector<Complexes> components;  // [node][time]
};

ShapeWaves read_shapes(const std::filesystem::path& file_name, const LimitCycle& cycle,
                       std::size_t n, std::size_t stations) {
  const hdf5::Reader file(file_name);
  const std::vector<double> all = file.list("/shape_times");
  hsize_t nodes_of_chord = hdf5::any;
  ShapeWaves waves;
  for (std::size_t s = 0; s < all.size(); ++s) {
    if (all[s] < cycle.from || all[s] > cycle.to) continue;
    const hdf5::Array nodes =
        file.read(fmt::format("/position/{:06}", s), {hdf5::any, nodes_of_chord, 3});
    if (nodes.shape[0] != stations + 1)
      file.fail(
          fmt::format("has shapes of another span than the {} stations of history.h5", stations));
    const std::size_t chord = nodes_of_chord = nodes.shape[1];
    const auto first = static_cast<std::size_t>((1 - chord_share) * static_cast<double>(chord - 1));
    waves.y.resize(chord - first, 0.0);
    waves.components.resize(chord - first);
    for (std::size_t j = first; j < chord; ++j) {
      std::vector<std::vector<double>> z(stations);
      for (std::size_t m = 0; m < stations; ++m) {
        const double* node = nodes.values.data() + 3 * (m * chord + j);
        waves.y[j - first] += node[1] / static_cast<double>(stations);
        z[m] = {node[2]};
      }
      waves.components[j - first].push_back(spanwise_components(z)[n][0]);
    }
    waves.t.push_back(all[s]);
  }
  for (double& y : waves.y) y /= static_cast<double>(waves.t.size());
  return waves;
}

void find_on_flag(const RunHistory& run, const LimitCycle& cycle, double k_x, std::size_t n,
                  const std::filesystem::path& folder, Angles& angles) {
  if (!std::filesystem::is_regular_file(folder / "shapes.h5")) {
    angles.notes.emplace_back(
        "theta_s: the run kept no shapes, in which the wave along the chord is seen; give it "
        "dns.output.shape_interval");
    return;
  }
  const ShapeWaves waves = read_shapes(folder / "shapes.h5", cycle, n, run.planes());
  const double periods = (cycle.to - cycle.from) * cycle.f_s;
  if (static_cast<double>(waves.t.size()) < fewest_shapes_a_period * periods) {
    angles.notes.push_back(
        fmt::format("theta_s: the run kept {} shapes in {:.3g} periods, and {} a "
                    "period are needed; shorten dns.output.shape_interval",
                    waves.t.size(), periods, fewest_shapes_a_period));
    return;
  }
  std::vector<Turning> turnings;
  for (const Complexes& values : waves.components)
    turnings.push_back(turning_of(waves.t, values, two_pi * cycle.f_s));
  angles.theta_s_deg = angle_deg(k_x, chordwise_wavenumber(waves.y, turnings));
}

// Two probes one behind the other.
const ProbeHistory* behind(const ProbeHistory& probe, const std::vector<ProbeHistory>& all) {
  const ProbeHistory* nearest = nullptr;
  for (const ProbeHistory& other : all)
    if (std::abs(other.z - probe.z) < same_z && other.y > probe.y &&
        (nearest == nullptr || other.y < nearest->y))
      nearest = &other;
  return nearest;
}

void find_in_wake(const RunHistory& run, const LimitCycle& cycle, double k_x, std::size_t n,
                  double U, Angles& angles) {
  const ProbeHistory *first = nullptr, *second = nullptr;
  for (const ProbeHistory& probe : run.probes)
    if (second == nullptr && (second = behind(probe, run.probes)) != nullptr) first = &probe;
  if (second == nullptr) {
    angles.notes.emplace_back(
        "theta_v: the run has no two probes at one z, between which the wake's phase changes");
    return;
  }
  const Turning a = turning_in(cycle, run.t, spanwise_components(first->w)[n]);
  const Turning b = turning_in(cycle, run.t, spanwise_components(second->w)[n]);
  if (std::min(a.excess(), b.excess()) < travels_above || a.is_along_x() != b.is_along_x()) {
    angles.notes.push_back(fmt::format(
        "theta_v: component {} of the wake's velocity does not travel along the span", n));
    return;
  }
  const double sign = a.is_along_x() ? 1 : -1, distance = second->y - first->y;
  const double change =
      a.is_along_x() ? std::arg(b.along / a.along) : -std::arg(b.against / a.against);
  const double carried = (two_pi * cycle.f_s - sign * k_x * U) * distance;
  const double turns = std::round((carried - change) / two_pi);
  angles.theta_v_deg = angle_deg(k_x, (change + two_pi * turns) / distance);
}

}  // namespace

double Turning::excess() const {
  const double sum = std::norm(along) + std::norm(against);
  return sum > 0 ? std::abs(std::norm(along) - std::norm(against)) / sum : 0;
}

Turning turning_of(const std::vector<double>& t, const Complexes& values, double omega) {
  Turning turning;
  double weights = 0;
  for (std::size_t k = 0; k + 1 < t.size(); ++k) {
    const double phase = (t[k] - t.front()) / (t.back() - t.front());
    const double weight = (1 - std::cos(two_pi * phase)) * (t[k + 1] - t[k == 0 ? 0 : k - 1]);
    turning.along += weight * values[k] * std::polar(1.0, omega * t[k]);
    turning.against += weight * values[k] * std::polar(1.0, -omega * t[k]);
    weights += weight;
  }
  turning.along /= weights;
  turning.against /= weights;
  return turning;
}

double chordwise_wavenumber(const std::vector<double>& y, const std::vector<Turning>& turnings) {
  // Along +x the component goes as exp(i(k_y y - omega t)), along -x as its conjugate.
  const bool is_along_x = turnings.back().is_along_x();
  std::vector<double> phases;
  for (const Turning& turning : turnings) {
    double phase = is_along_x ? std::arg(turning.along) : -std::arg(turning.against);
    if (!phases.empty()) phase -= two_pi * std::round((phase - phases.back()) / two_pi);
    phases.push_back(phase);
  }
  double constant = 0, k_y = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl_fit_linear(y.data(), 1, phases.data(), 1, y.size(), &constant, &k_y, &c00, &c01, &c11,
                 &residual);
  return k_y;
}

double angle_deg(double k_x, double k_y) {
  return std::atan2(k_x, k_y) * 180 / std::numbers::pi;
}

Angles find_angles(const RunHistory& run, const std::vector<Complexes>& components,
                   const LimitCycle& cycle, double U, const std::filesystem::path& folder) {
  Angles angles;
  if (!run.has_span()) {
    angles.notes.emplace_back(
        "theta_s, theta_v: a flag in two dimensions has no wave along a span");
    return angles;
  }
  const std::size_t n = dominant_wave(run, components, cycle);
  const Turning edge = n == 0 ? Turning{} : turning_in(cycle, run.t, components[n]);
  if (edge.excess() < travels_above) {
    angles.notes.push_back(
        n == 0 ? "theta_s, theta_v: the limit cycle is the same along the span"
               : fmt::format("theta_s, theta_v: component {} along the span stands and does not "
                             "travel",
                             n));
    return angles;
  }
  const double k_x = two_pi * static_cast<double>(n) / run.span;
  find_on_flag(run, cycle, k_x, n, folder, angles);
  find_in_wake(run, cycle, k_x, n, U, angles);
  return angles;
}

}  // namespace pennon::analysis

#include "analysis/signal/limit_cycle.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <iterator>
#include <numbers>

#include "analysis/signal/spanwise_amplitudes.hpp"

namespace pennon::analysis {
namespace {

// How far below the mean a signal must go between two passages, in half ranges.
constexpr double hysteresis = 0.2;
// Rows are refined to so many a period and more, for ranges are taken from them.
constexpr std::size_t refinement = 4;
// The part of a run, at its end, where its mean and half range are taken.
constexpr double last_third = 1.0 / 3;

double mean_of(const Spline& spline, double from, double to) {
  return spline.integral(from, to) / (to - from);
}

// Times at which the signal passes upward through its mean in the last part of the run, and before
// it as long as the signal keeps passing.
std::vector<double> upward_passages(const std::vector<double>& t,
                                    const std::vector<double>& signal) {
  const double from = begin_of_last(last_third, t);
  const double mean = mean_of(Spline(t, signal), from, t.back());
  const double depth = hysteresis * half_range(signal, rows_between(t, from, t.back()));
  std::vector<double> passages;
  bool was_below = false;
  for (std::size_t row = 1; row < t.size(); ++row) {
    const double before = signal[row - 1] - mean, now = signal[row] - mean;
    was_below = was_below || before < -depth;
    if (!was_below || before >= 0 || now < 0) continue;
    passages.push_back(t[row - 1] + (t[row] - t[row - 1]) * before / (before - now));
    was_below = false;
  }
  return passages;
}

template <class Member>
double scatter(const std::vector<Period>& periods, Member member) {
  const auto [low, high] = std::ranges::minmax(periods, {}, member);
  double sum = 0;
  for (const Period& period : periods) sum += period.*member;
  return (high.*member - low.*member) * static_cast<double>(periods.size()) / sum;
}

bool is_periodic(const std::vector<Period>& periods) {
  const Scatter found = scatter_of(periods);
  return found.amplitude <= periodic_within && found.length <= periodic_within;
}

// Why the trailing edge has no limit cycle; empty where it has one.
std::string fault_of(const std::vector<Period>& periods, double amplitude) {
  if (amplitude < at_rest)
    return fmt::format("limit cycle: the flag is at rest, its trailing edge swings by {:.2g} L",
                       amplitude);
  if (periods.size() < fewest_periods_of_cycle)
    return fmt::format(
        "limit cycle: the run has {} whole periods of the trailing edge, and {} are "
        "needed; run longer",
        periods.size(), fewest_periods_of_cycle);
  const Scatter found = scatter_of(periods);
  if (is_periodic(periods)) return {};
  return fmt::format(
      "limit cycle: the last {} periods differ by {:.2g} % in amplitude and {:.2g} % "
      "in length, above {:.2g} %: the run is not periodic, or not yet",
      periods.size(), 100 * found.amplitude, 100 * found.length, 100 * periodic_within);
}

void find_shedding(const RunHistory& run, const Settings& settings, LimitCycleResult& result) {
  const ProbeHistory* probe = probe_of(run, settings);
  if (probe == nullptr) {
    result.notes.emplace_back("f_v: the run has no probe in the wake; give it dns.probes");
    return;
  }
  const std::vector<Period> periods =
      last_periods(run.t, probe->w.front(), static_cast<std::size_t>(settings.periods));
  if (periods.size() < fewest_periods_of_cycle || scatter_of(periods).length > periodic_within) {
    result.notes.push_back(
        fmt::format("f_v: the velocity at y = {:.4g}, z = {:.4g} is not periodic within {:.2g} %",
                    probe->y, probe->z, 100 * periodic_within));
    return;
  }
  result.cycle->f_v = frequency_of(periods);
}

// The mean square of a signal about its mean.
double mean_square(const std::vector<double>& t, const std::vector<double>& values, double from,
                   double to) {
  const double mean = mean_of(Spline(t, values), from, to);
  std::vector<double> squares;
  squares.reserve(values.size());
  for (const double value : values) squares.push_back((value - mean) * (value - mean));
  return mean_of(Spline(t, squares), from, to);
}

// Where the trailing edge swings most in the last third of the run, in spans.
double antinode_share_of(const RunHistory& run) {
  const std::size_t stations = run.z.size();
  if (stations == 1) return 0;
  constexpr std::size_t fewest_places = 96;
  const std::size_t places = stations * ((fewest_places + stations - 1) / stations);
  const Rows rows = rows_between(run.t, begin_of_last(last_third, run.t), run.t.back());
  std::vector<std::vector<double>> z;
  for (const std::vector<double>& station : run.z)
    z.emplace_back(station.begin() + static_cast<std::ptrdiff_t>(rows.begin),
                   station.begin() + static_cast<std::ptrdiff_t>(rows.end));
  double largest = -1, share = 0;
  for (std::size_t k = 0; k < places; ++k) {
    const double place = static_cast<double>(k) / static_cast<double>(places);
    const double swing = half_range(between_stations(z, place), {0, z.front().size()});
    constexpr double rounding = 1e-9;  // of waves that are as large everywhere the first station's
    if (swing <= largest * (1 + rounding)) continue;
    largest = swing;
    share = place;
  }
  return share;
}

// The amplitude of a signal at a frequency, over a time that holds whole periods of it.
double amplitude_at(double frequency, const std::vector<double>& t,
                    const std::vector<double>& signal, double from, double to) {
  constexpr std::size_t samples = 4096;
  const std::vector<double> times = equal_times(from, to, samples + 1);
  const std::vector<double> values = at_times(t, signal, times);
  std::complex<double> sum = 0;
  for (std::size_t k = 0; k < samples; ++k)
    sum += values[k] * std::polar(1.0, -2 * std::numbers::pi * frequency * (times[k] - from));
  return 2 * std::abs(sum) / static_cast<double>(samples);
}

// Whether neighbouring periods differ, told by the frequencies of the pairs of periods; a note, or
// empty.
std::string note_on_pairs(const RunHistory& run, const std::vector<double>& z,
                          const LimitCycle& cycle) {
  constexpr double felt = 0.05;
  const double at_f = amplitude_at(cycle.f_s, run.t, z, cycle.from, cycle.to);
  const double at_double = amplitude_at(2 * cycle.f_s, run.t, z, cycle.from, cycle.to);
  if (at_double > at_f)
    return fmt::format(
        "limit cycle: the swing at 2 f_s is {:.2g} times that at f_s: two swings make "
        "a period, and f_s is their subharmonic",
        at_double / at_f);
  const std::size_t pairs = cycle.periods.size() / 2;
  if (pairs == 0) return {};
  const double begin = cycle.periods[cycle.periods.size() - 2 * pairs].begin;
  const double at_half = amplitude_at(cycle.f_s / 2, run.t, z, begin, cycle.to);
  if (at_half <= felt * at_f) return {};
  return fmt::format(
      "limit cycle: every other period is another: the swing at f_s/2 is {:.2g} times "
      "that at f_s",
      at_half / at_f);
}

}  // namespace

std::string why_rows_are_too_few(const RunHistory& run, double from, double to, double omega,
                                 double mu) {
  constexpr double fewest_rows_a_period = 8;
  const Rows rows = rows_between(run.t, from, to);
  const double period = 2 * std::numbers::pi / omega;
  const double a_period = static_cast<double>(rows.end - rows.begin) * period / (to - from);
  if (a_period < fewest_rows_a_period)
    return fmt::format(
        "the history has {:.2g} rows a period, and {} are needed; shorten "
        "dns.output.history_interval",
        a_period, fewest_rows_a_period);
  if (mu == 0) return {};
  double square = 0;
  for (const std::vector<double>& z : run.z)
    square += mean_square(run.t, z, from, to) / static_cast<double>(run.z.size());
  const double kinetic = mean_of(Spline(run.t, run.column("flag_kinetic")), from, to);
  const double accounted = mu * omega * omega * square / 2;
  constexpr double most =
      4;  // an alias with eight rows a period has an energy of 16 times and more
  if (!(kinetic > most * accounted)) return {};
  return fmt::format(
      "the flag's kinetic energy is {:.2g} times what a swing with the frequency of "
      "{:.3g} V/L accounts for: the rows are too few for the flapping, and this is "
      "its alias; shorten dns.output.history_interval",
      kinetic / accounted, omega / (2 * std::numbers::pi));
}

std::vector<Period> last_periods(const std::vector<double>& t, const std::vector<double>& signal,
                                 std::size_t most) {
  const std::vector<double> times = equal_times(t.front(), t.back(), refinement * t.size());
  const std::vector<double> values = at_times(t, signal, times);
  const std::vector<double> passages = upward_passages(times, values);
  std::vector<Period> periods;
  const std::size_t count = passages.empty() ? 0 : std::min(most, passages.size() - 1);
  for (std::size_t k = passages.size() - count; k < passages.size(); ++k)
    periods.push_back({passages[k - 1], passages[k] - passages[k - 1],
                       half_range(values, rows_between(times, passages[k - 1], passages[k]))});
  return periods;
}

double frequency_of(const std::vector<Period>& periods) {
  std::vector<double> index, begin;
  for (const Period& period : periods) {
    index.push_back(static_cast<double>(index.size()));
    begin.push_back(period.begin);
  }
  index.push_back(static_cast<double>(index.size()));
  begin.push_back(periods.back().begin + periods.back().length);
  double first = 0, length = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl_fit_linear(index.data(), 1, begin.data(), 1, index.size(), &first, &length, &c00, &c01, &c11,
                 &residual);
  return 1 / length;
}

Scatter scatter_of(const std::vector<Period>& periods) {
  return {scatter(periods, &Period::amplitude), scatter(periods, &Period::length)};
}

std::size_t antinode_of(const RunHistory& run) {
  const Rows rows = rows_between(run.t, begin_of_last(last_third, run.t), run.t.back());
  const auto swing = [&](const std::vector<double>& z) { return half_range(z, rows); };
  return static_cast<std::size_t>(std::ranges::max_element(run.z, {}, swing) - run.z.begin());
}

const ProbeHistory* probe_of(const RunHistory& run, const Settings& settings) {
  const auto distance = [&](const ProbeHistory& probe) {
    return std::hypot(probe.y - settings.probe_y, probe.z - settings.probe_z);
  };
  const auto nearest = std::ranges::min_element(run.probes, {}, distance);
  return nearest == run.probes.end() ? nullptr : &*nearest;
}

LimitCycleResult find_limit_cycle(const RunHistory& run, const Settings& settings, double mu) {
  LimitCycleResult result;
  LimitCycle cycle;
  cycle.antinode = antinode_of(run);
  cycle.antinode_share = antinode_share_of(run);
  const std::vector<double> z = between_stations(run.z, cycle.antinode_share);
  cycle.periods = last_periods(run.t, z, static_cast<std::size_t>(settings.periods));
  const double swing =
      half_range(z, rows_between(run.t, begin_of_last(last_third, run.t), run.t.back()));
  if (std::string fault = fault_of(cycle.periods, swing); !fault.empty()) {
    result.notes.push_back(std::move(fault));
    return result;
  }
  for (const Period& period : cycle.periods)
    cycle.A_over_L += period.amplitude / static_cast<double>(cycle.periods.size());
  cycle.f_s = frequency_of(cycle.periods);
  cycle.St = 2 * cycle.A_over_L * cycle.f_s;
  cycle.from = cycle.periods.front().begin;
  cycle.to = cycle.periods.back().begin + cycle.periods.back().length;
  if (const std::string fault =
          why_rows_are_too_few(run, cycle.from, cycle.to, 2 * std::numbers::pi * cycle.f_s, mu);
      !fault.empty()) {
    result.notes.push_back("limit cycle: " + fault);
    return result;
  }
  if (std::string note = note_on_pairs(run, z, cycle); !note.empty())
    result.notes.push_back(std::move(note));
  cycle.C_D_mean = mean_of(Spline(run.t, run.column("C_D")), cycle.from, cycle.to);
  const std::vector<double>& C_L = run.column("C_L");
  cycle.C_L_amp = half_range(C_L, rows_between(run.t, cycle.from, cycle.to));
  result.cycle = std::move(cycle);
  find_shedding(run, settings, result);
  return result;
}

}  // namespace pennon::analysis

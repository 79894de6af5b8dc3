#include "analysis/signal/flapping_phases.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/signal/series.hpp"
#include "analysis/signal/spanwise_amplitudes.hpp"

namespace pennon::analysis {
namespace {

constexpr double grown = 0.5, ruling_share = 0.9, steady_within = 0.1;
constexpr double last_fifth = 0.2;

std::size_t largest_at(const std::vector<std::vector<double>>& envelopes, std::size_t row) {
  const auto at_row = [row](const std::vector<double>& envelope) { return envelope[row]; };
  return static_cast<std::size_t>(std::ranges::max_element(envelopes, {}, at_row) -
                                  envelopes.begin());
}

std::vector<double> total_of(const std::vector<std::vector<double>>& envelopes) {
  std::vector<double> total(envelopes.front().size(), 0.0);
  for (const std::vector<double>& envelope : envelopes)
    for (std::size_t row = 0; row < total.size(); ++row)
      total[row] = std::hypot(total[row], envelope[row]);
  return total;
}

// Whether the amplitude was as large before the last part of the run as it ever is.
bool has_stopped_growing(const std::vector<double>& t, const std::vector<double>& total) {
  const std::size_t last = rows_between(t, begin_of_last(last_fifth, t), t.back()).begin;
  const auto largest_in = [&](auto begin, auto end) { return *std::max_element(begin, end); };
  const auto middle = total.begin() + static_cast<std::ptrdiff_t>(last);
  return largest_in(total.begin(), middle + 1) >=
         (1 - steady_within) * largest_in(middle, total.end());
}

void find_first_end(const std::vector<double>& t, const std::vector<double>& total, double period,
                    Phases& phases) {
  const double level = grown * *std::ranges::max_element(total);
  const Rows first_period = rows_between(t, t.front(), t.front() + period);
  if (total[first_period.end - 1] >= level) {
    phases.notes.emplace_back(
        "I_end: the run has half of its largest amplitude or more within its first period, and no "
        "phase of growth");
    return;
  }
  if (!has_stopped_growing(t, total)) {
    phases.notes.emplace_back("I_end: the amplitude still grows at the end of the run");
    return;
  }
  const auto reached = std::ranges::find_if(total, [&](double e) { return e >= level; });
  phases.I_end = t[static_cast<std::size_t>(reached - total.begin())];
}

// The first row of the end of the run in which all rows satisfy a condition.
template <class Condition>
std::size_t first_of_last(std::size_t rows, Condition holds) {
  std::size_t first = rows;
  while (first > 0 && holds(first - 1)) --first;
  return first;
}

void find_second_end(const std::vector<double>& t,
                     const std::vector<std::vector<double>>& envelopes,
                     const std::vector<double>& total, Phases& phases) {
  const double begin = begin_of_last(last_fifth, t);
  const double mean = Spline(t, total).integral(begin, t.back()) / (t.back() - begin);
  const std::vector<double>& ruling = envelopes[phases.ruling];
  const std::size_t first = first_of_last(t.size(), [&](std::size_t row) {
    const double share = std::pow(ruling[row] / total[row], 2);
    return share >= ruling_share && std::abs(total[row] - mean) <= steady_within * mean;
  });
  if (first < t.size() && t[first] <= begin) {
    phases.II_end = t[first];
    return;
  }
  phases.notes.push_back(fmt::format(
      "II_end: over the last fifth of the run component {} does not hold {:.3g} % of the squares "
      "of "
      "the amplitudes ({:.3g} % at the end) with an amplitude steady within {:.3g} %: phase III is "
      "not reached",
      phases.ruling, 100 * ruling_share, 100 * std::pow(ruling.back() / total.back(), 2),
      100 * steady_within));
}

}  // namespace

Phases find_phases(const std::vector<double>& t, const std::vector<std::vector<double>>& amplitudes,
                   double period) {
  std::vector<std::vector<double>> envelopes;
  envelopes.reserve(amplitudes.size());
  for (const std::vector<double>& amplitude : amplitudes)
    envelopes.push_back(envelope(t, amplitude, period));
  const std::vector<double> total = total_of(envelopes);
  Phases phases;
  phases.ruling = largest_at(envelopes, t.size() - 1);
  if (total.back() < at_rest) {
    phases.notes.push_back(
        fmt::format("I_end, II_end: the flag does not flap, its amplitude is {:.2g} L at the end",
                    total.back()));
    return phases;
  }
  find_first_end(t, total, period, phases);
  find_second_end(t, envelopes, total, phases);
  return phases;
}

}  // namespace pennon::analysis

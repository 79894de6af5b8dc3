#include "analysis/signal/linear_phase.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/signal/exponentials.hpp"
#include "analysis/signal/series.hpp"

namespace pennon::analysis {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

// Of a window: samples of a fit, rows it must hold, periods it must span.
constexpr std::size_t most_samples = 128, fewest_rows_of_window = 16;
constexpr double fewest_periods = 2;
constexpr std::array<std::size_t, 3> exponentials = {2, 4, 12};
// Displacements within which a flag is sought to be linear, in L; with the amplitude of a limit
// cycle near 0.14 L, Stuart's and Landau's growth rate at these is 18, 5 and 0.5 % below the
// linear.
constexpr std::array<double, 3> linear_amplitudes = {0.06, 0.03, 0.01};
// A flag that comes to rest is looked at until its swings have faded to these shares of the
// largest.
constexpr std::array<double, 3> faded = {1e-3, 1e-2, 1e-1};
constexpr std::array<double, 5> first_shares = {0, 0.15, 0.3, 0.45, 0.6};
constexpr std::array<double, 3> last_shares = {1, 0.8, 0.6};
// Fits that differ by less agree; beyond the other they contradict each other. Shares of |lambda|.
constexpr double agreement = 0.005, contradiction = 0.1;
// With less of the energy the leading mode is one of several.
constexpr double least_share = 0.8;

struct Leading {
  std::complex<double> lambda;
  double amplitude = 0, share = 0;
};

// The energy of one exponential between the times a and b after its amplitude.
double energy(const Exponential& e, double a, double b) {
  const double rate = 2 * e.lambda.real();
  const double integral =
      std::abs(rate) * (b - a) < 1e-9 ? b - a : (std::exp(rate * b) - std::exp(rate * a)) / rate;
  return std::norm(e.amplitude) * integral;
}

// Whether an exponential swings at least once in a time.
bool swings_in(const Exponential& e, double length) {
  return std::abs(e.lambda.imag()) * length >= fewest_periods * two_pi / 2;
}

// Whether it stands still in that time, in a signal from which a growth was taken out.
bool is_offset(const Exponential& e, double growth, double length) {
  constexpr double still = 0.5;
  return std::abs(e.lambda + growth) * length < still;
}

// The energy in the later half of their time of the samples without their offset: a flag may hang
// or be blown to one side.
double energy_about_offset(const Complexes& samples, const std::vector<Exponential>& all,
                           double growth, double dt) {
  const double length = dt * static_cast<double>(samples.size() - 1);
  double sum = 0;
  for (std::size_t k = samples.size() / 2; k < samples.size(); ++k) {
    std::complex<double> left = samples[k];
    for (const Exponential& e : all)
      if (is_offset(e, growth, length))
        left -= e.amplitude * std::exp(e.lambda * (dt * static_cast<double>(k)));
    sum += std::norm(left);
  }
  return sum * dt;
}

// Of two exponentials that differ by the sign of their frequency at most: a mode of a real signal.
bool is_same_mode(const Exponential& e, const std::complex<double>& lambda) {
  return std::min(std::abs(e.lambda - lambda), std::abs(e.lambda - std::conj(lambda))) <
         agreement * std::abs(lambda);
}

// `growth`: what was taken out of the samples.
std::optional<Leading> leading_of(const Complexes& samples, double growth, double dt,
                                  std::size_t most) {
  const double length = dt * static_cast<double>(samples.size() - 1);
  const std::vector<Exponential> all = fit_exponentials(samples, dt, most);
  double largest = 0;
  std::optional<Exponential> leading;
  for (const Exponential& e : all) {
    const double own = energy(e, length / 2, length);
    if (!std::isfinite(own) || !swings_in(e, length) || own <= largest) continue;
    largest = own;
    leading = e;
  }
  if (!leading) return std::nullopt;
  Leading mode{leading->lambda};
  const double of_all = energy_about_offset(samples, all, growth, dt);
  for (const Exponential& e : all) {
    if (!is_same_mode(e, leading->lambda)) continue;
    mode.share += energy(e, length / 2, length) / of_all;
    mode.amplitude += std::abs(e.amplitude);
  }
  return mode;
}

Complexes without_growth(Complexes samples, double growth_of_step) {
  for (std::size_t k = 0; k < samples.size(); ++k)
    samples[k] *= std::exp(-growth_of_step * static_cast<double>(k));
  return samples;
}

std::optional<Leading> fit(const std::vector<double>& t, const Complexes& signal, double from,
                           double to, std::size_t most) {
  const Rows rows = rows_between(t, from, to);
  if (rows.end < rows.begin + fewest_rows_of_window) return std::nullopt;
  const std::size_t count = std::min(most_samples, rows.end - rows.begin);
  const Complexes samples = at_times(t, signal, equal_times(from, to, count));
  const double dt = (to - from) / static_cast<double>(count - 1);
  std::optional<Leading> leading = leading_of(samples, 0, dt, most);
  if (!leading) return leading;
  // Once more, without the growth found: else the last e-folding alone would decide.
  const double sigma = leading->lambda.real();
  leading = leading_of(without_growth(samples, sigma * dt), sigma, dt, most);
  if (leading) leading->lambda += sigma;
  return leading;
}

// By how much fits to parts of the window differ from the fit to all of it.
double disagreement(const Growth& growth) {
  return std::hypot(growth.sigma_error, growth.omega_error);
}

double size(const Growth& growth) {
  return std::hypot(growth.sigma, growth.omega);
}

// The longest stretch from `start` on in which no station is further from z = 0 than `limit`.
std::array<double, 2> longest_stretch(const std::vector<double>& t,
                                      const std::vector<double>& displacement, double limit,
                                      double start) {
  std::array<double, 2> longest = {start, start};
  std::optional<double> begin;
  for (std::size_t row = rows_between(t, start, start).begin; row < t.size(); ++row) {
    if (displacement[row] > limit) {
      begin.reset();
      continue;
    }
    if (!begin) begin = t[row];
    if (t[row] - *begin > longest[1] - longest[0]) longest = {*begin, t[row]};
  }
  return longest;
}

// The last time in a stretch at which a station is further out than a share of the largest there.
double end_of_fading(const std::vector<double>& t, const std::vector<double>& displacement,
                     const std::array<double, 2>& stretch, double share) {
  const Rows rows = rows_between(t, stretch[0], stretch[1]);
  double largest = 0;
  for (std::size_t row = rows.begin; row < rows.end; ++row)
    largest = std::max(largest, displacement[row]);
  std::size_t last = rows.end;
  while (last > rows.begin && displacement[last - 1] <= share * largest) --last;
  return last == rows.end || last == rows.begin ? stretch[1] : t[last - 1];
}

// Of each station, between two times.
std::vector<double> means_of(const RunHistory& run, double from, double to) {
  const Rows rows = rows_between(run.t, from, to);
  std::vector<double> means;
  for (const std::vector<double>& station : run.z) {
    double sum = 0;
    for (std::size_t row = rows.begin; row < rows.end; ++row) sum += station[row];
    means.push_back(sum / static_cast<double>(rows.end - rows.begin));
  }
  return means;
}

// Of all stations, from where each is taken to rest.
std::vector<double> largest_displacement(const RunHistory& run, const std::vector<double>& rest) {
  std::vector<double> largest(run.t.size(), 0.0);
  for (std::size_t m = 0; m < run.z.size(); ++m)
    for (std::size_t row = 0; row < largest.size(); ++row)
      largest[row] = std::max(largest[row], std::abs(run.z[m][row] - rest[m]));
  return largest;
}

// Where the stations may rest: at z = 0; where they are at first, and at last, if they are
// deflected there.
std::vector<std::vector<double>> places_of_rest(const RunHistory& run, double start) {
  std::vector<std::vector<double>> places = {std::vector<double>(run.z.size(), 0.0)};
  const double end = run.t.back(), quarter = (end - start) / 4;
  for (const double from : {start, end - quarter}) {
    std::vector<double> means = means_of(run, from, from + quarter);
    if (std::ranges::any_of(means, [](double mean) { return std::abs(mean) > at_rest; }))
      places.push_back(std::move(means));
  }
  return places;
}

// The component that swings with the most energy between two times.
std::size_t leading_wave(const std::vector<double>& t, const std::vector<Complexes>& components,
                         double from, double to) {
  const Rows rows = rows_between(t, from, to);
  std::size_t leading = 0;
  double most = -1;
  for (std::size_t n = 0; n < components.size(); ++n) {
    std::complex<double> mean = 0;
    double sum = 0;
    for (std::size_t row = rows.begin; row < rows.end; ++row)
      mean += components[n][row] / static_cast<double>(rows.end - rows.begin);
    for (std::size_t row = rows.begin; row < rows.end; ++row)
      sum += std::norm(components[n][row] - mean);
    if (sum > most) {
      most = sum;
      leading = n;
    }
  }
  return leading;
}

struct Candidate {
  Growth growth;
  std::size_t wave;
};

// The fits to windows in a stretch.
void add_candidates(const RunHistory& run, const std::vector<Complexes>& components,
                    const std::array<double, 2>& stretch, std::vector<Candidate>& candidates) {
  const double length = stretch[1] - stretch[0];
  for (const double first : first_shares)
    for (const double last : last_shares) {
      const double from = stretch[0] + first * length, to = stretch[0] + last * length;
      if (first >= last) continue;
      const std::size_t wave = leading_wave(run.t, components, (from + to) / 2, to);
      if (const auto growth = fit_growth(run.t, components[wave], from, to))
        candidates.push_back({*growth, wave});
    }
}

// The longest window of those whose parts agree as well as the best, within a factor two.
const Candidate* best_of(const std::vector<Candidate>& candidates) {
  double least = std::numeric_limits<double>::infinity();
  for (const Candidate& c : candidates) least = std::min(least, disagreement(c.growth));
  const Candidate* best = nullptr;
  const auto length = [](const Candidate& c) { return c.growth.to - c.growth.from; };
  for (const Candidate& c : candidates)
    if (disagreement(c.growth) <= std::max(2 * least, agreement * size(c.growth)) &&
        (best == nullptr || length(c) > length(*best)))
      best = &c;
  return best;
}

bool contradicts_itself(const Growth& growth) {
  return disagreement(growth) > contradiction * size(growth);
}

LinearPhase in_given_window(const RunHistory& run, const std::vector<Complexes>& components,
                            double from, double to) {
  LinearPhase phase;
  phase.wave = leading_wave(run.t, components, (from + to) / 2, to);
  phase.growth = fit_growth(run.t, components[phase.wave], from, to);
  if (!phase.growth)
    phase.note = fmt::format(
        "growth: no mode swings over two periods between t = {:.4g} and {:.4g}", from, to);
  else if (contradicts_itself(*phase.growth))
    phase.note = "growth: fits to parts of the given window differ by more than a tenth";
  return phase;
}

std::optional<Growth> fit_growth(const std::vector<double>& t, const Complexes& signal, double from,
                                 double to, std::size_t most) {
  const std::optional<Leading> whole = fit(t, signal, from, to, most);
  if (!whole || whole->share < least_share ||
      std::abs(whole->lambda.imag()) * (to - from) < fewest_periods * two_pi)
    return std::nullopt;
  Growth growth;
  growth.sigma = whole->lambda.real();
  growth.omega = std::abs(whole->lambda.imag());
  growth.from = from;
  growth.to = to;
  growth.amplitude = whole->amplitude;
  growth.share = whole->share;
  const double third = (to - from) / 3;
  for (const double shift : {0.0, 0.5, 1.0}) {
    const auto part = fit(t, signal, from + shift * third, from + (shift + 2) * third, most);
    if (!part) return std::nullopt;
    growth.sigma_error = std::max(growth.sigma_error, std::abs(part->lambda.real() - growth.sigma));
    growth.omega_error =
        std::max(growth.omega_error, std::abs(std::abs(part->lambda.imag()) - growth.omega));
  }
  return growth;
}

}  // namespace

std::optional<Growth> fit_growth(const std::vector<double>& t, const Complexes& signal, double from,
                                 double to) {
  std::optional<Growth> best;
  for (const std::size_t most : exponentials)
    if (const auto growth = fit_growth(t, signal, from, to, most))
      if (!best || disagreement(*growth) < disagreement(*best)) best = growth;
  return best;
}

LinearPhase find_linear_phase(const RunHistory& run, const std::vector<Complexes>& components,
                              const Settings& settings, double start) {
  if (settings.from || settings.to)
    return in_given_window(run, components, settings.from.value_or(run.t.front()),
                           settings.to.value_or(run.t.back()));
  std::vector<std::array<double, 2>> stretches;
  std::vector<Candidate> candidates;
  const auto try_stretch = [&](const std::array<double, 2>& stretch) {
    if (std::ranges::find(stretches, stretch) != stretches.end()) return;
    stretches.push_back(stretch);
    add_candidates(run, components, stretch, candidates);
  };
  for (const std::vector<double>& rest : places_of_rest(run, start)) {
    const std::vector<double> displacement = largest_displacement(run, rest);
    for (const double limit : linear_amplitudes) {
      const std::array<double, 2> stretch = longest_stretch(run.t, displacement, limit, start);
      try_stretch(stretch);
      for (const double share : faded)
        try_stretch({stretch[0], end_of_fading(run.t, displacement, stretch, share)});
    }
  }
  LinearPhase phase;
  const Candidate* best = best_of(candidates);
  if (best == nullptr) {
    phase.note = fmt::format(
        "growth: the trailing edge does not swing two periods within {} L in a single mode; give "
        "the window with --from and --to",
        linear_amplitudes.front());
    return phase;
  }
  if (contradicts_itself(best->growth)) {
    phase.note = fmt::format(
        "growth: no window with a single exponential was found; the best, from t = {:.4g} to "
        "{:.4g}, gives {:.3g} with deviations to {:.2g}; give the window with --from and --to",
        best->growth.from, best->growth.to, best->growth.sigma, best->growth.sigma_error);
    return phase;
  }
  phase.growth = best->growth;
  phase.wave = best->wave;
  return phase;
}

}  // namespace pennon::analysis

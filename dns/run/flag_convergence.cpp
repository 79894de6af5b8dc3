#include "dns/run/flag_convergence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <cmath>

#include "common/errors.hpp"
#include "common/progress.hpp"
#include "dns/flag/frequency.hpp"
#include "dns/run/flag_run.hpp"

namespace pennon::dns {
namespace {

constexpr std::size_t z_column = 3;  // of the history

// The limit of the last two, whose errors go with the square of the spacing.
double extrapolated(const Convergence& c) {
  const std::size_t last = c.values.size() - 1;
  const double ratio = std::pow(c.spacing(last - 1) / c.spacing(last), 2);
  return c.values[last] + (c.values[last] - c.values[last - 1]) / (ratio - 1);
}

double fitted_order(const Convergence& c) {
  std::vector<double> log_h, log_error;
  for (std::size_t k = 0; k < c.values.size(); ++k) {
    log_h.push_back(std::log(c.spacing(k)));
    log_error.push_back(std::log(std::abs(c.values[k] - c.limit)));
  }
  double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl_fit_linear(log_h.data(), 1, log_error.data(), 1, log_h.size(), &intercept, &slope, &c00, &c01,
                 &c11, &residual);
  return slope;
}

double deflection_with(std::int64_t n, Settings settings, const FlagParameters& flag,
                       const OutputFolder& folder) {
  settings.n_x = settings.flag.n_y = n;
  const OutputFolder own(folder / fmt::format("n-{}", n));
  return run_flag(settings, flag, std::nullopt, {}, own, false).rows.back()[z_column];
}

double frequency_with(double dt, Settings settings, const FlagParameters& flag,
                      const OutputFolder& folder) {
  settings.dt = dt;
  const OutputFolder own(folder / fmt::format("dt-{}", dt));
  const FlagRunResult found = run_flag(settings, flag, std::nullopt, {}, own, false);
  std::vector<double> z;
  for (const HistoryRow& row : found.rows) z.push_back(row[z_column]);
  const auto frequency = angular_frequency(z, dt);
  if (!frequency)
    throw SolverError(fmt::format(
        "no frequency can be read from the probe's z with dns.convergence.dt = {}: it does not "
        "pass zero twice until dns.t_end = {}; take a longer t_end, a probe off the nodal lines, "
        "or a "
        "start that moves it",
        dt, settings.t_end));
  return *frequency;
}

}  // namespace

double Convergence::spacing(std::size_t k) const {
  return refinement == Refinement::step ? sizes[k] : 1 / (sizes[k] - 1);
}

Convergence run_convergence(const Settings& settings, const FlagParameters& flag,
                            const OutputFolder& folder, bool shows_progress) {
  const auto& [is_given, n, dt, reference] = settings.convergence;
  Convergence found;
  found.refinement = dt.empty() ? Refinement::grid : Refinement::step;
  Progress progress("convergence", static_cast<std::int64_t>(n.size() + dt.size()), shows_progress);
  const auto add = [&](double size, double value) {
    found.sizes.push_back(size);
    found.values.push_back(value);
    progress.advance_to(static_cast<std::int64_t>(found.values.size()));
  };
  for (const std::int64_t nodes : n)
    add(static_cast<double>(nodes), deflection_with(nodes, settings, flag, folder));
  for (const double step : dt) add(step, frequency_with(step, settings, flag, folder));
  found.is_limit_given = reference.has_value();
  found.limit = reference ? *reference : extrapolated(found);
  found.order = fitted_order(found);
  return found;
}

}  // namespace pennon::dns

#include "dns/run/flag_convergence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/errors.hpp"
#include "common/io/atomic_file.hpp"
#include "common/io/csv.hpp"
#include "common/io/hdf5.hpp"
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

void write(const Convergence& c, const OutputFolder& folder) {
  const std::string value = value_name(c.refinement);
  const bool is_step = c.refinement == Refinement::step;
  std::vector<double> h, error;
  CsvText table(is_step ? "angular frequency of the probe by the time step, in V/L"
                        : "deflection of the probe by the nodes along each side, in L",
                {size_name(c.refinement), "spacing", value, "error"});
  for (std::size_t k = 0; k < c.values.size(); ++k) {
    h.push_back(c.spacing(k));
    error.push_back(std::abs(c.values[k] - c.limit));
    table.row({c.sizes[k], h.back(), c.values[k], error.back()});
  }
  write_file(folder / "convergence.csv", table.text());
  hdf5::Writer file(folder / "convergence.h5");
  file.attributes(
      {{"kind", "flag_convergence"}, {"of", value}, {"limit", c.limit}, {"order", c.order}});
  const std::string unit = is_step ? ", in V/L" : ", in L";
  file.write("/h", {h.size()}, h, {{"meaning", is_step ? "time step, in L/V" : "1/(n - 1)"}});
  file.write("/" + value, {h.size()}, c.values,
             {{"meaning", (is_step ? "angular frequency of the probe" : "z of the probe") + unit}});
  file.write("/error", {h.size()}, error, {{"meaning", "|" + value + " - limit|" + unit}});
  file.finish();
}

double deflection_with(std::int64_t n, Settings settings, const FlagParameters& flag,
                       const OutputFolder& folder) {
  settings.n_x = settings.flag.n_y = n;
  const OutputFolder own(folder / fmt::format("n-{}", n));
  return run(settings, flag, std::nullopt, std::nullopt, own, false).last[z_column];
}

double frequency_with(double dt, Settings settings, const FlagParameters& flag,
                      const OutputFolder& folder) {
  settings.dt = dt;
  const OutputFolder own(folder / fmt::format("dt-{}", dt));
  run(settings, flag, std::nullopt, std::nullopt, own, false);
  const hdf5::Array history = hdf5::Reader(own / "history.h5").read("/history");
  std::vector<double> z;
  for (std::size_t row = 0; row < history.shape[0]; ++row)
    z.push_back(history.values[row * history.shape[1] + z_column]);
  const auto frequency = angular_frequency(z, dt);
  if (!frequency)
    throw SolverError(fmt::format(
        "no frequency can be read from the probe's z with dns.convergence.dt = {}: it does not "
        "pass "
        "zero twice until dns.t_end = {}; take a longer t_end, a probe off the nodal lines, or a "
        "start that moves it",
        dt, settings.t_end));
  return *frequency;
}

}  // namespace

double Convergence::spacing(std::size_t k) const {
  return refinement == Refinement::step ? sizes[k] : 1 / (sizes[k] - 1);
}

const char* value_name(Refinement refinement) {
  return refinement == Refinement::step ? "frequency" : "deflection";
}

const char* size_name(Refinement refinement) {
  return refinement == Refinement::step ? "dt" : "n";
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
  write(found, folder);
  return found;
}

nlohmann::ordered_json to_json(const Convergence& convergence) {
  nlohmann::ordered_json json;
  if (convergence.refinement == Refinement::step)
    json["dt"] = convergence.sizes;
  else
    json["n"] = std::vector<std::int64_t>(convergence.sizes.begin(), convergence.sizes.end());
  json[value_name(convergence.refinement)] = convergence.values;
  json["limit"] = convergence.limit;
  json["limit_is_given"] = convergence.is_limit_given;
  json["order"] = convergence.order;
  return json;
}

}  // namespace pennon::dns

#include "dns/flag_convergence.hpp"

#include <fmt/format.h>
#include <gsl/gsl_fit.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "common/atomic_file.hpp"
#include "common/csv.hpp"
#include "common/hdf5.hpp"
#include "common/progress.hpp"
#include "dns/flag_run.hpp"

namespace pennon::dns {
namespace {

constexpr std::size_t z_column = 3;  // of the history

double spacing(std::int64_t n) {
  return 1 / static_cast<double>(n - 1);
}

// The limit of two grids whose errors go with the square of the spacing.
double extrapolated(const Convergence& c) {
  const std::size_t last = c.n.size() - 1;
  const double ratio = std::pow(spacing(c.n[last - 1]) / spacing(c.n[last]), 2);
  return c.deflection[last] + (c.deflection[last] - c.deflection[last - 1]) / (ratio - 1);
}

double fitted_order(const Convergence& c) {
  std::vector<double> log_h, log_error;
  for (std::size_t k = 0; k < c.n.size(); ++k) {
    log_h.push_back(std::log(spacing(c.n[k])));
    log_error.push_back(std::log(std::abs(c.deflection[k] - c.limit)));
  }
  double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
  gsl_fit_linear(log_h.data(), 1, log_error.data(), 1, log_h.size(), &intercept, &slope, &c00, &c01,
                 &c11, &residual);
  return slope;
}

void write(const Convergence& c, const OutputFolder& folder) {
  std::vector<double> h, error;
  CsvText table("deflection of the probe by the nodes along each side, in L",
                {"n", "spacing", "deflection", "error"});
  for (std::size_t k = 0; k < c.n.size(); ++k) {
    h.push_back(spacing(c.n[k]));
    error.push_back(std::abs(c.deflection[k] - c.limit));
    table.row({static_cast<double>(c.n[k]), h.back(), c.deflection[k], error.back()});
  }
  write_file(folder / "convergence.csv", table.text());
  hdf5::Writer file(folder / "convergence.h5");
  file.attributes({{"kind", "flag_convergence"}, {"limit", c.limit}, {"order", c.order}});
  file.write("/h", {h.size()}, h, {{"meaning", "1/(n - 1)"}});
  file.write("/deflection", {h.size()}, c.deflection, {{"meaning", "z of the probe, in L"}});
  file.write("/error", {h.size()}, error, {{"meaning", "|deflection - limit|, in L"}});
  file.finish();
}

}  // namespace

Convergence run_convergence(const Settings& settings, const FlagParameters& flag,
                            const OutputFolder& folder, bool shows_progress) {
  Convergence convergence;
  const auto grids = static_cast<std::int64_t>(settings.convergence.n.size());
  Progress progress("convergence", grids, shows_progress);
  for (const std::int64_t n : settings.convergence.n) {
    Settings one = settings;
    one.n_x = one.flag.n_y = n;
    const RunResult result = run(one, flag, std::nullopt, std::nullopt,
                                 OutputFolder(folder / fmt::format("n-{}", n)), false);
    convergence.n.push_back(n);
    convergence.deflection.push_back(result.last[z_column]);
    progress.advance_to(static_cast<std::int64_t>(convergence.n.size()));
  }
  convergence.is_limit_given = settings.convergence.reference.has_value();
  convergence.limit =
      convergence.is_limit_given ? *settings.convergence.reference : extrapolated(convergence);
  convergence.order = fitted_order(convergence);
  write(convergence, folder);
  return convergence;
}

nlohmann::ordered_json to_json(const Convergence& convergence) {
  return {{"n", convergence.n},
          {"deflection", convergence.deflection},
          {"limit", convergence.limit},
          {"limit_is_given", convergence.is_limit_given},
          {"order", convergence.order}};
}

}  // namespace pennon::dns

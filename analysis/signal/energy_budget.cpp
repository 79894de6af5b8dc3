#include "analysis/signal/energy_budget.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "analysis/signal/series.hpp"
#include "common/smooth_rise.hpp"

namespace pennon::analysis {
namespace {

std::vector<double> sum(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::ranges::transform(a, b, result.begin(), std::plus());
  return result;
}

std::vector<double> difference(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> result(a.size());
  std::ranges::transform(a, b, result.begin(), std::minus());
  return result;
}

// The power of the force on the flag along the stream.
std::vector<double> stream_power(const RunHistory& run, const RunContext& context) {
  std::vector<double> power;
  for (std::size_t row = 0; row < run.t.size(); ++row)
    power.push_back(smooth_rise(run.t[row], context.ramp) *
                    (run.column("C_D")[row] + context.U * run.column("C_S")[row]) / 2);
  return power;
}

// Without the kick's work, which the first row after the kick shows whole.
std::vector<double> exchange_of(const RunHistory& run, const std::vector<double>& along_stream,
                                double kick_end) {
  std::vector<double> exchange =
      sum(running_integral(run.t, difference(run.column("wall_power"), along_stream)),
          run.column("fluid_work"));
  const std::size_t after = kick_end > 0 ? rows_between(run.t, kick_end, kick_end).begin : 0;
  const double work_before = exchange[std::min(after, exchange.size() - 1)];
  for (std::size_t row = 0; row < exchange.size(); ++row)
    exchange[row] = row < after ? 0 : exchange[row] - work_before;
  return exchange;
}

double largest_size(const std::vector<double>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace

EnergyBudget energy_budget(const RunHistory& run, const RunContext& context) {
  EnergyBudget e;
  e.t = run.t;
  e.fluid = run.column("kinetic");
  e.flag_kinetic = run.column("flag_kinetic");
  e.bending = run.column("bending");
  e.stretch = sum(run.column("stretch_2d"), run.column("stretch_3d"));
  e.gravity = run.column("gravity");
  e.flag = sum(sum(e.flag_kinetic, e.bending), sum(e.stretch, e.gravity));
  e.total = sum(e.fluid, e.flag);
  const std::vector<double> along_stream = stream_power(run, context);
  e.received = running_integral(run.t, sum(along_stream, run.column("outer_power")));
  e.balance = difference(e.total, e.received);
  e.lost =
      sum(running_integral(run.t, run.column("dissipation")), run.column("damping_dissipated"));
  e.exchange = exchange_of(run, along_stream, context.kick_end);
  e.defect = sum(sum(run.column("energy_defect"), run.column("flag_defect")), e.exchange);
  const double scale = largest_size(sum(e.fluid, e.flag_kinetic));
  e.residual = scale > 0 ? largest_size(e.defect) / scale : 0;
  e.residual_exchange = scale > 0 ? largest_size(e.exchange) / scale : 0;
  for (const double change :
       change_in_convective_period(e.t, e.defect, difference(e.total, e.gravity)))
    if (std::isfinite(change))
      e.residual_per_time = std::max(e.residual_per_time, std::abs(change));
  return e;
}

std::vector<double> change_in_convective_period(const std::vector<double>& t,
                                                const std::vector<double>& values,
                                                const std::vector<double>& relative_to) {
  const Spline spline(t, values);
  std::vector<double> change;
  for (std::size_t row = 0; row < t.size(); ++row)
    change.push_back(t[row] - 1 < t.front()
                         ? std::numeric_limits<double>::quiet_NaN()
                         : (values[row] - spline(t[row] - 1)) / relative_to[row]);
  return change;
}

}  // namespace pennon::analysis

#include "analysis/signal/run_study.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "common/errors.hpp"

namespace pennon::analysis {
namespace {

void check_window(const RunHistory& run, const Settings& settings) {
  const double from = settings.from.value_or(run.t.front());
  const double to = settings.to.value_or(run.t.back());
  if (from < to && from >= run.t.front() && to <= run.t.back()) return;
  throw InputError(settings.from ? "--from" : "--to",
                   fmt::format("gives the window from t = {:.6g} to {:.6g}, which must be ordered "
                               "and lie in the run's, {:.6g} to {:.6g}",
                               from, to, run.t.front(), run.t.back()));
}

// Of the flapping: of the limit cycle, else of the linear phase, else the convective one.
double period_of(const LimitCycleResult& limit_cycle, const LinearPhase& linear) {
  if (limit_cycle.cycle) return 1 / limit_cycle.cycle->f_s;
  if (linear.growth) return 2 * std::numbers::pi / linear.growth->omega;
  return 1;
}

}  // namespace

std::vector<std::string> RunAnalysis::notes() const {
  std::vector<std::string> all;
  if (!linear.note.empty()) all.push_back(linear.note);
  for (const auto* some : {&limit_cycle.notes, &angles.notes, &phases.notes})
    all.insert(all.end(), some->begin(), some->end());
  return all;
}

RunAnalysis analyze_run(const std::filesystem::path& folder, const Settings& settings,
                        const RunContext& context) {
  RunAnalysis found;
  found.run = read_run_history(folder);
  check_window(found.run, settings);
  found.components = spanwise_components(found.run.z);
  found.linear = find_linear_phase(found.run, found.components, settings,
                                   std::max(context.release, context.kick_end));
  if (const auto& growth = found.linear.growth) {
    const std::string fault =
        why_rows_are_too_few(found.run, growth->from, growth->to, growth->omega, context.mu);
    if (!fault.empty()) found.linear = {{}, found.linear.wave, "growth: " + fault};
  }
  found.limit_cycle = find_limit_cycle(found.run, settings, context.mu);
  if (found.limit_cycle.cycle)
    found.angles =
        find_angles(found.run, found.components, *found.limit_cycle.cycle, context.U, folder);
  else
    found.angles.notes.emplace_back("theta_s, theta_v: angles are those of a limit cycle");
  found.phases = find_phases(found.run.t, moduli(found.components),
                             period_of(found.limit_cycle, found.linear));
  found.energy = energy_budget(found.run, context);
  return found;
}

}  // namespace pennon::analysis

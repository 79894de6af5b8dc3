#include "lsa/study.hpp"

#include <algorithm>

namespace pennon::lsa {
namespace {

// The critical mass ratio over the searched k_y, a curve for each span in the table.
Curve critical_mass_ratios(const Settings& settings, const Point& point,
                           const std::vector<Outcome>& outcomes) {
  CurveSettings curve;
  curve.is_given = true;
  curve.sweeps[static_cast<std::size_t>(Axis::k_y)] = settings.verdicts.k_y;
  Sweep spans;
  for (const Outcome& outcome : outcomes)
    if (std::ranges::find(spans.list, outcome.k_x()) == spans.list.end())
      spans.list.push_back(outcome.k_x());
  std::ranges::sort(spans.list);
  curve.sweeps[static_cast<std::size_t>(Axis::k_x)] = spans;
  return compute(curve, point, settings.theory);
}

}  // namespace

Result run(const Settings& settings, const FlagParameters& flag, const FlowParameters& flow,
           const OutputFolder& folder, bool shows_progress) {
  const Point point = point_of(flag, flow, settings);
  const Theory& theory = settings.theory;
  std::vector<Outcome> outcomes;
  if (settings.verdicts.is_given) outcomes = read_outcomes(settings.verdicts.table);

  Result result{
      .point = point, .stability = solve(point, theory), .has_cross_flow = theory.model.cross_flow};
  if (settings.marks.is_given) result.marks = read_outcomes(settings.marks.table);
  if (settings.curve.is_given) result.curve = compute(settings.curve, point, theory);
  if (settings.map.is_given)
    result.map = compute_map(settings.map, point, theory, result.marks, folder, shows_progress);
  if (const MostUnstableSettings& sought = settings.most_unstable; sought.is_given) {
    result.sought = sought.k_x ? Axis::k_x : Axis::k_y;
    result.most_unstable =
        most_unstable(point, theory, *result.sought, sought.k_x ? *sought.k_x : *sought.k_y);
  }
  if (settings.verdicts.is_given) {
    result.verdicts = compare(outcomes, point, theory, *settings.verdicts.k_y);
    result.critical_mass_ratios = critical_mass_ratios(settings, point, outcomes);
  }
  return result;
}

}  // namespace pennon::lsa

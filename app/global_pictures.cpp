#include "app/global_pictures.hpp"

#include <array>
#include <cmath>

#include "lsa/axis_attributes.hpp"
#include "lsa/curve.hpp"
#include "lsa/outcomes.hpp"

namespace pennon::app {
namespace {

using modes::global::CurveParameter;

lsa::Axis axis_of(CurveParameter parameter) {
  switch (parameter) {
    case CurveParameter::Re:
      return lsa::Axis::Re;
    case CurveParameter::k_x:
      return lsa::Axis::k_x;
    case CurveParameter::K_B:
      return lsa::Axis::K_B;
    default:
      return lsa::Axis::nu_s;
  }
}

// From the first point of the neutral curve to its last.
std::vector<modes::global::OtherCurve> local_theory(const Case& the_case,
                                                    const modes::global::NeutralCurve& neutral) {
  std::vector<modes::global::OtherCurve> curves;
  lsa::Theory theory = the_case.lsa.theory;
  if (neutral.points.size() < 2 ||
      (neutral.parameter == CurveParameter::K_B && !theory.model.bending))
    return curves;
  const double first = neutral.points.front().value, last = neutral.points.back().value;
  constexpr std::int64_t points = 250;
  constexpr double first_share = 1.0 / points;  // from 0 the added mass of Wu has no limit
  lsa::CurveSettings curve;
  curve.is_given = true;
  curve.sweeps[static_cast<std::size_t>(axis_of(neutral.parameter))] =
      Sweep{.from = first > 0 ? first : first_share * last,
            .to = last,
            .points = points,
            .scale = sweep(the_case.global_modes.neutral).scale,
            .list = {}};
  lsa::Point point = lsa::point_of(the_case.flag, the_case.flow, the_case.lsa);
  point.k_x = *the_case.global_modes.k_x;
  constexpr std::array names = {"two_d", "wu", "lamb", "minami"};
  for (std::size_t i = 0; i < names.size(); ++i) {
    theory.model.added_mass = static_cast<lsa::AddedMass>(i);
    lsa::Curve found = lsa::compute(curve, point, theory);
    curves.push_back({names[i], std::move(found.x), std::move(found.values.front())});
  }
  return curves;
}

// The outcomes without cross-flow that lie on the picture; those of the table are at the Reynolds
// number of the case.
OutcomePoints outcomes_over(CurveParameter parameter, const Case& the_case) {
  OutcomePoints points;
  if (!the_case.lsa.marks.is_given) return points;
  for (const lsa::Outcome& outcome : lsa::read_outcomes(the_case.lsa.marks.table)) {
    constexpr double same = 1e-9;
    const bool is_of_this_wave = std::abs(outcome.k_x() - *the_case.global_modes.k_x) < same;
    if (outcome.U != 0) continue;
    if (parameter == CurveParameter::k_x)
      points.add(outcome.k_x(), outcome.mu, outcome.is_unstable);
    else if (parameter == CurveParameter::Re && is_of_this_wave)
      points.add(the_case.flow.Re, outcome.mu, outcome.is_unstable);
  }
  return points;
}

}  // namespace

modes::global::NeutralPicture neutral_picture(const Case& the_case,
                                              const modes::global::NeutralCurve& neutral) {
  const modes::global::NeutralSettings& settings = the_case.global_modes.neutral;
  return {.title = settings.title,
          .axis = attributes(axis_of(neutral.parameter), sweep(settings).scale),
          .local_theory = local_theory(the_case, neutral),
          .outcomes = outcomes_over(neutral.parameter, the_case)};
}

modes::global::MapPicture map_picture(const Case& the_case) {
  const modes::global::MapSettings& settings = the_case.global_modes.map;
  return {.title = settings.title,
          .x_axis = attributes(axis_of(parameter(settings)), sweep(settings).scale),
          .mu_axis = attributes(lsa::Axis::mu, settings.mu->scale),
          .outcomes = outcomes_over(parameter(settings), the_case)};
}

}  // namespace pennon::app

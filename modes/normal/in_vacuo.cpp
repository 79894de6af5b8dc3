#include "modes/normal/in_vacuo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <memory>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "modes/normal/graded_breaks.hpp"
#include "modes/normal/tension.hpp"

namespace pennon::modes {
namespace {

// Shorter layers change no frequency by more than 1e-11, relatively: at a clamped edge the change
// is of the order of the length, elsewhere of its square or third power.
constexpr double shortest_clamped_layer = 1e-11;
constexpr double shortest_layer = 3e-6;
// Where T falls to zero, modes of a high m shorten toward the edge.
constexpr double layer_of_vanishing_tension = 0.03;
// Elements at an edge begin to widen at this fraction of the layer.
constexpr double share_of_layer = 0.3;

// Convergence is judged against a space with this share of the elements, whose error is some 100
// times larger: 16th order.
constexpr double share_of_elements = 0.75;
constexpr double largest_change = 1e-9;
// What roundoff leaves of the rigid rotation of a pinned flag without tension, against K_B.
constexpr double roundoff_of_rigid_motion = 1e-24;

// The ends of panels within which functions piecewise smooth on either are smooth.
std::vector<double> merged(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> all;
  std::ranges::set_union(a, b, std::back_inserter(all));
  return all;
}

Profile constant(double value) {
  return [value](double) { return value; };
}

}  // namespace

ChordwiseProblem chordwise_problem(TensionProfile profile, int n, double T_0,
                                   const FlagParameters& flag) {
  ChordwiseProblem problem;
  problem.K_B = flag.K_B;
  problem.nu_s = flag.nu_s;
  problem.k_x = spanwise_wavenumber(n, flag);
  problem.leading_edge = flag.leading_edge;
  problem.scale = T_0 + flag.K_B;
  problem.weight = constant(1);
  const double spanwise = flag.nu_s * T_0 * problem.k_x * problem.k_x;
  switch (profile) {
    case TensionProfile::blasius:
      problem.tension = [T_0](double y) { return T_0 * (1 - std::sqrt(y)); };
      problem.spanwise = [spanwise](double y) { return spanwise * (1 - std::sqrt(y)); };
      break;
    case TensionProfile::linear:
      problem.tension = [T_0](double y) { return T_0 * (1 - y); };
      problem.spanwise = constant(spanwise);
      break;
    case TensionProfile::constant:
      problem.tension = constant(T_0);
      problem.spanwise = constant(spanwise);
      break;
    case TensionProfile::wedge:
      problem.weight = [](double y) { return 1 - y; };
      problem.tension = [T_0](double y) { return T_0 * (1 - y); };
      problem.spanwise = [T_0, n](double y) { return T_0 * n * n / (1 - y); };
      problem.is_held_at_trailing_edge = n > 0;
      break;
  }
  return problem;
}

SplineSpace spline_space(TensionProfile profile, int elements, int n, double T_0,
                         const FlagParameters& flag) {
  const double along_span = 1 / std::max(1.0, spanwise_wavenumber(n, flag));
  const double bending = flag.K_B / T_0;  // infinite without tension
  const bool has_bending = flag.K_B > 0;
  const bool is_clamped = has_bending && flag.leading_edge == LeadingEdge::clamped;
  const auto layer = [&](double bending_layer, double shortest) {
    return share_of_layer * along_span * std::clamp(bending_layer / along_span, shortest, 1.0);
  };
  const double leading = has_bending                          ? std::sqrt(bending)
                         : profile == TensionProfile::blasius ? 0
                                                              : 1;
  double trailing = 1;
  if (profile != TensionProfile::constant)
    trailing = std::min(layer_of_vanishing_tension, has_bending ? std::cbrt(bending) : 1.0);
  else if (has_bending)
    trailing = std::sqrt(bending);
  return SplineSpace(
      graded_breaks(elements, layer(leading, is_clamped ? shortest_clamped_layer : shortest_layer),
                    layer(trailing, shortest_layer)));
}

namespace {

// The shapes on `elements` elements, and proof that fewer would have given the same.
ChordwiseShapes converged_shapes(const ChordwiseProblem& problem, const SplineSpace& space,
                                 const SplineSpace& coarse, int count, const std::string& what) {
  ChordwiseShapes shapes = solve(problem, space, count, what);
  const ChordwiseShapes fewer = solve(problem, coarse, count, what);
  for (std::size_t i = 0; i < shapes.lambda.size(); ++i) {
    const double change = std::abs(shapes.lambda[i] - fewer.lambda[i]);
    const double allowed =
        largest_change * shapes.lambda[i] + roundoff_of_rigid_motion * problem.scale;
    if (!(change <= allowed))
      throw SolverError(fmt::format(
          "{}: omega^2 of m = {} changes by {:.1e} of itself from {} elements to {}, more than {}; "
          "take more elements or ask for fewer modes",
          what, i + 1, change / shapes.lambda[i], coarse.breaks().size() - 1,
          space.breaks().size() - 1, largest_change));
  }
  return shapes;
}

}  // namespace

NormalModes in_vacuo_modes(const ModeRange& range, const FlagParameters& flag,
                           const FlowParameters& flow, TensionProfile profile, int elements) {
  const double T_0 = leading_edge_tension(flow.Re);
  if (!(T_0 + flag.K_B > 0))
    throw InputError("",
                     "the flag in vacuum has neither tension (flow.Re is not given) nor bending "
                     "stiffness (flag.K_B = 0), so it has no modes; give one of the two");
  if (elements < 2 * range.m)
    throw InputError(
        "", fmt::format("{} elements resolve at most {} modes along the chord, but m = {}; "
                        "at least {} are needed",
                        elements, elements / 2, range.m, 2 * range.m));
  const double no_wave_speed = std::numeric_limits<double>::quiet_NaN();
  const double c = T_0 > 0 ? std::sqrt(T_0 / flag.mu) : no_wave_speed;
  NormalModes result{Family::in_vacuo, flag.gamma, {}, {0, 1}, {}};
  for (const int n : range.n) {
    stop_if_interrupted("no modes are written before all are found; run again to begin anew");
    const ChordwiseProblem problem = chordwise_problem(profile, n, T_0, flag);
    const auto space =
        std::make_shared<const SplineSpace>(spline_space(profile, elements, n, T_0, flag));
    const int fewer = static_cast<int>(share_of_elements * elements);
    const std::string what = fmt::format("normal modes in vacuum, n = {}", n);
    const ChordwiseShapes shapes = converged_shapes(
        problem, *space, spline_space(profile, fewer, n, T_0, flag), range.m, what);
    for (int m = 1; m <= range.m; ++m) {
      const std::size_t i = static_cast<std::size_t>(m) - 1;
      const double omega = std::sqrt(std::max(0.0, shapes.lambda[i]) / flag.mu);
      result.modes.push_back({n, m, problem.k_x, omega / c, omega, 1,
                              [space, coefficients = shapes.coefficients[i]](double y) {
                                return space->value(coefficients, y);
                              }});
    }
    result.weight = problem.weight;
    result.panels = merged(result.panels, space->breaks());
  }
  return result;
}

}  // namespace pennon::modes

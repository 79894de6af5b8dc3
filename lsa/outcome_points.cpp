#include "lsa/outcome_points.hpp"

#include "common/io/outcome_points.hpp"

namespace pennon::lsa {

std::optional<double> coordinate(const Outcome& outcome, Axis axis) {
  switch (axis) {
    case Axis::mu:
      return outcome.mu;
    case Axis::k_x:
      return outcome.k_x();
    case Axis::gamma:
      return outcome.gamma;
    case Axis::U:
      return outcome.U;
    default:
      return std::nullopt;
  }
}

void write_outcome_points(hdf5::Writer& file, const std::vector<Outcome>& outcomes, Axis x,
                          const std::string& y, bool cross_flow) {
  std::optional<Axis> y_axis;
  if (y == "mu_cr") y_axis = Axis::mu;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (name(static_cast<Axis>(i)) == y) y_axis = static_cast<Axis>(i);
  if (!y_axis) return;
  OutcomePoints points;
  for (const Outcome& outcome : outcomes) {
    const auto along_x = coordinate(outcome, x);
    const auto along_y = coordinate(outcome, *y_axis);
    if (!along_x || !along_y || (outcome.U != 0 && !cross_flow)) continue;
    points.add(*along_x, *along_y, outcome.is_unstable);
  }
  write(points, file);
}

}  // namespace pennon::lsa

#include "lsa/outcome_points.hpp"

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

void OutcomePoints::add(double along_x, double along_y, bool is_unstable) {
  x.push_back(along_x);
  y.push_back(along_y);
  unstable.push_back(is_unstable ? 1 : 0);
}

void write(const OutcomePoints& points, hdf5::Writer& file) {
  if (points.x.empty()) return;
  file.write("/marks/x", {points.x.size()}, points.x);
  file.write("/marks/y", {points.y.size()}, points.y);
  file.write("/marks/unstable", {points.unstable.size()}, points.unstable,
             {{"meaning", "1: unstable in the table of outcomes, 0: stable"}});
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

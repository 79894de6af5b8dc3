#include "lsa/marks.hpp"

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

void write_marks(hdf5::Writer& file, const std::vector<Outcome>& outcomes, Axis x,
                 const std::string& y, bool cross_flow) {
  std::optional<Axis> y_axis;
  if (y == "mu_cr") y_axis = Axis::mu;
  for (std::size_t i = 0; i < axis_count; ++i)
    if (name(static_cast<Axis>(i)) == y) y_axis = static_cast<Axis>(i);
  if (!y_axis) return;
  std::vector<double> x_of, y_of, unstable;
  for (const Outcome& outcome : outcomes) {
    const auto along_x = coordinate(outcome, x);
    const auto along_y = coordinate(outcome, *y_axis);
    if (!along_x || !along_y || (outcome.U != 0 && !cross_flow)) continue;
    x_of.push_back(*along_x);
    y_of.push_back(*along_y);
    unstable.push_back(outcome.is_unstable ? 1 : 0);
  }
  if (x_of.empty()) return;
  file.write("/marks/x", {x_of.size()}, x_of);
  file.write("/marks/y", {y_of.size()}, y_of);
  file.write("/marks/unstable", {unstable.size()}, unstable,
             {{"meaning", "1: unstable in the table of outcomes, 0: stable"}});
}

}  // namespace pennon::lsa

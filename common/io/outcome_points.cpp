#include "common/io/outcome_points.hpp"

namespace pennon {

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

}  // namespace pennon

/// Known outcomes as points over two axes, which a picture shows as marks beside a curve or a map.
#pragma once

#include <vector>

#include "common/io/hdf5.hpp"

namespace pennon {

/// The coordinates of each outcome, and whether it was unstable (1) or stable (0).
struct OutcomePoints {
  std::vector<double> x, y, unstable;

  void add(double along_x, double along_y, bool is_unstable);
};

/// Writes /marks/x, /marks/y and /marks/unstable; nothing without points. Throws FileError.
void write(const OutcomePoints&, hdf5::Writer&);

}  // namespace pennon

/// Element boundaries along the chord, narrower toward edges where the solution varies over a short
/// length: h ~ 1/elements in the interior, h ~ (distance + layer)/elements near an edge.
#pragma once

#include <vector>

namespace pennon::modes {

/// `elements` + 1 increasing numbers from 0 to 1. `leading_layer`, `trailing_layer`: the length
/// over which the solution varies at y = 0 and y = 1; 1 or more leaves the elements there as they
/// are. Halving h everywhere (twice the elements) splits each element: the grading stays.
std::vector<double> graded_breaks(int elements, double leading_layer, double trailing_layer);

}  // namespace pennon::modes

#include "modes/normal/graded_breaks.hpp"

#include <cassert>
#include <cmath>

namespace pennon::modes {
namespace {

// Share of the elements that each decade of grading takes, against the interior's: large enough for
// elements near an edge to stay short against their distance from it.
constexpr double weight_of_layer = 0.1;
// Enough to exhaust a double in [0, 1].
constexpr int bisections = 64;

// Elements up to the distance d from an edge with this layer, but for a factor.
double elements_of_layer(double distance, double layer) {
  return weight_of_layer * std::log1p(distance / layer);
}

}  // namespace

std::vector<double> graded_breaks(int elements, double leading_layer, double trailing_layer) {
  assert(elements > 0 && leading_layer > 0 && trailing_layer > 0);
  const auto elements_up_to = [&](double y) {
    return y + elements_of_layer(y, leading_layer) + elements_of_layer(1, trailing_layer) -
           elements_of_layer(1 - y, trailing_layer);
  };
  std::vector<double> breaks{0};
  for (int i = 1; i < elements; ++i) {
    const double wanted = elements_up_to(1) * i / elements;
    double low = breaks.back();
    double high = 1;
    for (int step = 0; step < bisections; ++step) {
      const double middle = low + (high - low) / 2;
      (elements_up_to(middle) < wanted ? low : high) = middle;
    }
    breaks.push_back(high);
  }
  breaks.push_back(1);
  return breaks;
}

}  // namespace pennon::modes

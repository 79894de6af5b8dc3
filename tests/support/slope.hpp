/// The rate of change of a quantity that is known step by step.
#pragma once

#include <array>

namespace pennon::test {

/// A quantity at three steps of equal length.
class Slope {
 public:
  void add(double value) { values_ = {value, values_[0], values_[1]}; }
  double by_time(double dt) const {
    return (1.5 * values_[0] - 2 * values_[1] + 0.5 * values_[2]) / dt;
  }

 private:
  std::array<double, 3> values_{};
};

}  // namespace pennon::test

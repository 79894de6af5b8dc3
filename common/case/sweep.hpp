/// A sweep: the values that one parameter of a case takes in turn along an axis of a curve or map,
/// either equally (or logarithmically equally) spaced points or a list. The interval within which
/// each of them has to lie is a Range (range.hpp).
#pragma once

#include <cstdint>
#include <vector>

namespace pennon {

enum class Scale { linear, log };

struct Sweep {
  double from = 0;  ///< from < to
  double to = 0;
  std::int64_t points = 0;
  Scale scale = Scale::linear;
  std::vector<double> list;  ///< when not empty, the values themselves; the rest is not used

  std::int64_t size() const {
    return list.empty() ? points : static_cast<std::int64_t>(list.size());
  }
  /// The i-th value, 0 <= i < size(). Of spaced points the first is exactly `from` and the last
  /// exactly `to`.
  double at(std::int64_t i) const;
  /// Whether each value is above the one before: not so for an unordered list, or for more spaced
  /// points than there are doubles between `from` and `to`.
  bool is_increasing() const;
  /// All values: size() doubles.
  std::vector<double> values() const;
};

}  // namespace pennon

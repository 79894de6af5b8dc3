/// A sweep: the values one parameter of a case takes along an axis of a curve or map, either a
/// range of equally (or logarithmically equally) spaced points or a list.
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
  std::vector<double> list;  ///< when not empty, the values themselves; the range is then unused

  std::int64_t size() const {
    return list.empty() ? points : static_cast<std::int64_t>(list.size());
  }
  /// The i-th value, 0 <= i < size(); the first is exactly `from` and the last exactly `to`.
  double at(std::int64_t i) const;
  /// Whether each value is above the one before: not so for an unordered list, or a range with more
  /// points than there are doubles between its ends.
  bool is_increasing() const;
  /// All values: size() doubles.
  std::vector<double> values() const;
};

}  // namespace pennon

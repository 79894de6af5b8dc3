#include "common/case/range.hpp"

#include <fmt/format.h>

namespace pennon {

std::string Range::text() const {
  if (high < extreme) return fmt::format(">= {} and <= {}", low, high);
  if (low >= 1) return fmt::format(">= {}", low);
  if (low > 0) return fmt::format("> 0 ({} to {})", low, high);
  if (low == 0) return fmt::format(">= 0 (up to {})", high);
  return fmt::format("of magnitude up to {}", high);
}

}  // namespace pennon

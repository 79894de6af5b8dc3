/// How deep a TOML text nests its tables by dotted names, found without parsing it. The parser
/// limits how deep values nest, but not names: a name of 10^5 parts would exhaust the stack.
#pragma once

#include <cstddef>
#include <string_view>

namespace pennon {

/// The largest number of parts of any dotted name of the text ("lsa.map" has two), and its line.
struct DottedName {
  std::size_t parts = 0;
  std::size_t line = 1;
};
DottedName deepest_name(std::string_view toml);

}  // namespace pennon

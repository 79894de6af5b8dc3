/// Whether bytes are text: UTF-8, as TOML, SVG and JSON require.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace pennon {

/// The number of bytes of the character that begins a text that is not empty; 0 where those bytes
/// are not UTF-8 (RFC 3629: neither overlong nor a surrogate).
std::size_t utf8_length(std::string_view text);

bool is_utf8(std::string_view text);

/// The text as a terminal may show it: what is not UTF-8 and control characters, but for the line
/// feed and the tabulator, become "?", so that no text from a file can command the terminal.
std::string printable(std::string_view text);

}  // namespace pennon

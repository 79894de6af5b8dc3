#include "common/utf8.hpp"

#include <array>
#include <cstdint>

namespace pennon {
namespace {

// The characters of each length: the leading byte's mark and its bits, and the least code point.
struct Form {
  std::size_t length;
  unsigned char mask, mark;
  std::uint32_t least;
};
constexpr std::array<Form, 4> forms = {
    {{1, 0x80, 0x00, 0}, {2, 0xe0, 0xc0, 0x80}, {3, 0xf0, 0xe0, 0x800}, {4, 0xf8, 0xf0, 0x10000}}};

}  // namespace

std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  for (const Form& form : forms) {
    if ((byte(0) & form.mask) != form.mark) continue;
    if (text.size() < form.length) return 0;
    std::uint32_t code = byte(0) & static_cast<unsigned char>(~form.mask);
    for (std::size_t i = 1; i < form.length; ++i) {
      if ((byte(i) & 0xc0) != 0x80) return 0;
      code = (code << 6) | (byte(i) & 0x3fU);
    }
    const bool is_surrogate = code >= 0xd800 && code < 0xe000;
    return code >= form.least && code <= 0x10ffff && !is_surrogate ? form.length : 0;
  }
  return 0;
}

bool is_utf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (length == 0) return false;
    text.remove_prefix(length);
  }
  return true;
}

std::string printable(std::string_view text) {
  std::string shown;
  while (!text.empty()) {
    const auto first = static_cast<unsigned char>(text.front());
    const std::size_t length = utf8_length(text);
    constexpr unsigned char deleted = 0x7f, first_of_c1 = 0xc2, end_of_c1 = 0xa0;
    const bool is_c1 =
        length == 2 && first == first_of_c1 && static_cast<unsigned char>(text[1]) < end_of_c1;
    const bool is_control = (first < ' ' && first != '\n' && first != '\t') || first == deleted;
    if (length == 0 || is_control || is_c1)
      shown += '?';
    else
      shown += text.substr(0, length);
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return shown;
}

}  // namespace pennon

#include "common/case/toml_depth.hpp"

#include <algorithm>

namespace pennon {
namespace {

// What begins at the head of the text: a string in any of TOML's four quotes, a comment, or else
// one character.
std::size_t token_length(std::string_view text) {
  const char first = text.front();
  if (first == '#') return std::min(text.find('\n'), text.size());
  if (first != '"' && first != '\'') return 1;
  const bool is_multi_line = text.size() >= 3 && text[1] == first && text[2] == first;
  const std::string_view quotes = text.substr(0, is_multi_line ? 3 : 1);
  for (std::size_t i = quotes.size(); i < text.size(); ++i) {
    if (text.substr(i).starts_with(quotes)) {
      std::size_t end = i + quotes.size();
      // A multi-line string may end in one or two quotes of its own.
      if (is_multi_line)
        while (end < std::min(i + 5, text.size()) && text[end] == first) ++end;
      return end;
    }
    if (text[i] == '\n' && !is_multi_line) return i;
    if (text[i] == '\\' && first == '"') ++i;
  }
  return text.size();
}

}  // namespace

DottedName deepest_name(std::string_view toml) {
  DottedName deepest;
  DottedName current{1, 1};
  while (!toml.empty()) {
    const std::string_view token = toml.substr(0, token_length(toml));
    if (token == ".")
      ++current.parts;
    else if (token.size() == 1 &&
             std::string_view("=,[]{}\n").find(token) != std::string_view::npos)
      current.parts = 1;
    current.line += static_cast<std::size_t>(std::ranges::count(token, '\n'));
    if (current.parts > deepest.parts) deepest = current;
    toml.remove_prefix(token.size());
  }
  return deepest;
}

}  // namespace pennon

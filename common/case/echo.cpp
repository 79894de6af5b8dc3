#include "common/case/echo.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string_view>

#include "common/utf8.hpp"

namespace pennon {
namespace {

constexpr std::size_t longest_echo = 60;

}  // namespace

std::string shortened(const std::string& text) {
  std::size_t end = 0;
  while (end < text.size() && end < longest_echo)
    end += std::max<std::size_t>(utf8_length(std::string_view(text).substr(end)), 1);
  return end < text.size() ? text.substr(0, end) + "..." : text;
}

std::string toml_of(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string toml_of(const toml::node& node) {
  if (const auto* number = node.as_floating_point()) return toml_of(number->get());
  if (const toml::array* list = node.as_array()) {
    std::string text = "[";
    for (const toml::node& value : *list) text += (text.size() > 1 ? ", " : "") + toml_of(value);
    return text + "]";
  }
  if (const toml::table* table = node.as_table()) {
    std::string text = "{";
    for (const auto& [name, value] : *table)
      text += fmt::format("{} {} = {}", text.size() > 1 ? "," : "", name.str(), toml_of(value));
    return text + (text.size() > 1 ? " }" : "}");
  }
  std::ostringstream text;
  node.visit([&](const auto& value) { text << value; });
  return text.str();
}

std::string echo(const toml::node& node) {
  std::string shown = toml_of(node);
  std::replace(shown.begin(), shown.end(), '\n', ' ');
  return shortened(shown);
}

std::string echo(const std::string& name) {
  const auto is_bare = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (!name.empty() && std::ranges::all_of(name, is_bare)) return shortened(name);
  return echo(toml::value<std::string>(name));
}

std::string kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

}  // namespace pennon

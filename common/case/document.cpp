#include "common/case/document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <span>

#include "common/case/echo.hpp"
#include "common/case/toml_depth.hpp"
#include "common/utf8.hpp"

namespace pennon {
namespace {

constexpr std::size_t most_name_parts = 16;  // far more than any case needs: lsa.map has two

toml::table parse(std::string_view text, const std::string& name) {
  if (text.find('\0') != std::string_view::npos)
    throw InputError(name,
                     "is not a case file: it holds binary data (a NUL byte); a case is TOML text");
  if (const DottedName deepest = deepest_name(text); deepest.parts > most_name_parts)
    throw InputError(fmt::format("{}:{}", name, deepest.line),
                     fmt::format("has a name of {} parts joined by dots; no name has more than {}",
                                 deepest.parts, most_name_parts));
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& fault) {
    throw InputError(fmt::format("{}:{}", name, fault.source().begin.line),
                     fmt::format("is not TOML: {} (column {})", fault.description(),
                                 fault.source().begin.column));
  }
}

std::vector<std::string> split(std::string_view dotted) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= dotted.size();) {
    const std::size_t dot = std::min(dotted.find('.', begin), dotted.size());
    parts.emplace_back(dotted.substr(begin, dot - begin));
    begin = dot + 1;
  }
  return parts;
}

// The value of an override: TOML where it parses as one value, else the text itself.
toml::table parse_value(const std::string& text) {
  try {
    if (deepest_name(text).parts <= most_name_parts) {
      toml::table parsed = toml::parse("value = " + text);
      if (parsed.size() == 1) return parsed;
    }
  } catch (const toml::parse_error&) {
    // not TOML: taken as text below
  }
  return toml::table{{"value", text}};
}

// Says that a node and all in it come from an override.
void mark_overridden(Document& document, const toml::node& node, const std::string& where) {
  document.override_places[&node] = where;
  if (const toml::table* table = node.as_table())
    for (const auto& [key, child] : *table) mark_overridden(document, child, where);
}

// The table an override's key is in, made where it is not there; null where a value is in its way.
toml::table* table_of(Document& document, std::span<const std::string> path,
                      const std::string& where) {
  toml::table* table = &document.root;
  for (const std::string& name : path) {
    toml::node* child = table->get(name);
    if (child == nullptr) {
      child = &table->insert_or_assign(name, toml::table{}).first->second;
      mark_overridden(document, *child, where);
    }
    table = child->as_table();
    if (table == nullptr) return nullptr;
  }
  return table;
}

}  // namespace

std::string Document::place(const toml::node& node) const {
  if (const auto found = override_places.find(&node); found != override_places.end())
    return found->second;
  return fmt::format("{}:{}", name, node.source().begin.line);
}

Document parse_document(std::string_view text, const std::string& name) {
  return {parse(text, name), name};
}

void apply_override(Document& document, const std::string& assignment) {
  const std::string where = "--set " + shortened(assignment);
  const auto refuse = [&](std::string what) {
    document.refused_overrides.push_back({where, std::move(what)});
  };
  const std::size_t equals = assignment.find('=');
  const std::vector<std::string> path = split(assignment.substr(0, equals));
  const bool has_empty_part = std::ranges::any_of(path, &std::string::empty);
  if (!is_utf8(assignment)) return refuse("is not text in UTF-8");
  if (equals == std::string::npos || path.size() < 2 || path.size() > most_name_parts ||
      has_empty_part)
    return refuse("must have the form table.key=value, for example flag.mu=0.1");
  toml::table* table = table_of(document, std::span(path).first(path.size() - 1), where);
  if (table == nullptr)
    return refuse(fmt::format("a part of {} is a value and not a table, so it has no keys",
                              shortened(assignment.substr(0, assignment.rfind('.', equals)))));
  const toml::table parsed = parse_value(assignment.substr(equals + 1));
  const auto place = table->insert_or_assign(path.back(), *parsed.get("value")).first;
  mark_overridden(document, place->second, where);
}

}  // namespace pennon

#include "common/case/schema.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/case/echo.hpp"

namespace pennon {
namespace {

std::string toml(double value) {
  return toml_of(value);
}
std::string toml(std::int64_t value) {
  return fmt::format("{}", value);
}
std::string toml(bool value) {
  return value ? "true" : "false";
}

std::string toml(const std::string& value) {
  std::string text = "\"";
  for (const char letter : value) {
    const auto code = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') text += '\\';
    if (code < 0x20 || code == 0x7f)
      text += fmt::format("\\u{:04X}", code);
    else
      text += letter;
  }
  return text + '"';
}

template <class Values>
std::string toml_list(const Values& values) {
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const auto& value : values) texts.push_back(toml(value));
  return fmt::format("[{}]", fmt::join(texts, ", "));
}

std::string toml(const Sweep& sweep) {
  if (!sweep.list.empty()) return toml_list(sweep.list);
  return fmt::format("{{ from = {}, to = {}, points = {}, scale = \"{}\" }}", toml(sweep.from),
                     toml(sweep.to), sweep.points, sweep.scale == Scale::log ? "log" : "linear");
}

// The bound value as TOML; none when the key is unset.
struct ValueText {
  using Text = std::optional<std::string>;
  Text operator()(const double* v) const { return toml(*v); }
  Text operator()(const std::int64_t* v) const { return toml(*v); }
  Text operator()(const std::optional<std::int64_t>* v) const {
    return *v ? Text(toml(**v)) : Text();
  }
  Text operator()(const bool* v) const { return toml(*v); }
  Text operator()(const std::string* v) const { return toml(*v); }
  Text operator()(const std::array<double, 3>* v) const { return toml_list(*v); }
  Text operator()(const std::vector<double>* v) const { return toml_list(*v); }
  Text operator()(const std::vector<std::int64_t>* v) const { return toml_list(*v); }
  Text operator()(const std::vector<std::string>* v) const { return toml_list(*v); }
  Text operator()(const std::optional<double>* v) const { return *v ? Text(toml(**v)) : Text(); }
  Text operator()(const std::optional<Sweep>* v) const { return *v ? Text(toml(**v)) : Text(); }
  Text operator()(const Choice& v) const {
    const auto chosen = v.chosen();
    return chosen ? Text(toml(v.names[*chosen])) : Text();
  }
};

struct TypeName {
  std::string operator()(const double*) const { return "number"; }
  std::string operator()(const std::optional<double>*) const { return "number"; }
  std::string operator()(const std::int64_t*) const { return "integer"; }
  std::string operator()(const std::optional<std::int64_t>*) const { return "integer"; }
  std::string operator()(const bool*) const { return "true or false"; }
  std::string operator()(const std::string*) const { return "text"; }
  std::string operator()(const std::array<double, 3>*) const { return "three numbers"; }
  std::string operator()(const std::vector<double>*) const { return "list of numbers"; }
  std::string operator()(const std::vector<std::int64_t>*) const { return "list of integers"; }
  std::string operator()(const std::vector<std::string>*) const { return "list of texts"; }
  std::string operator()(const std::optional<Sweep>*) const { return "range or list"; }
  std::string operator()(const Choice&) const { return "choice"; }
};

bool holds_numbers(const Binding& value) {
  const std::string type = std::visit(TypeName(), value);
  return type.find("number") != std::string::npos || type.find("integer") != std::string::npos ||
         type.find("range") != std::string::npos;
}

std::string allowed(const Key& key) {
  if (const Choice* choice = std::get_if<Choice>(&key.value))
    return fmt::format("{}", fmt::join(choice->names, ", "));
  if (!key.known.empty()) return fmt::format("{}", fmt::join(key.known, ", "));
  return holds_numbers(key.value) ? key.range.text() : "";
}

std::string default_of(const Key& key) {
  if (key.is_required) return "required";
  if (!key.default_text.empty()) return key.default_text;
  return std::visit(ValueText(), key.value).value_or("none");
}

}  // namespace

std::string resolved_text(const Schema& schema) {
  std::string text;
  for (const Table& table : schema.tables) {
    if (table.is_given != nullptr && !*table.is_given) continue;
    text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", table.name);
    for (const Key& key : table.keys)
      if (const auto value = std::visit(ValueText(), key.value))
        text += fmt::format("{} = {}\n", key.name, *value);
  }
  return text;
}

std::string reference_text(const Schema& schema) {
  std::string text;
  for (const Table& table : schema.tables) {
    text += fmt::format("\n## [{}]\n\n{}\n\n", table.name, table.doc);
    text += "| key | type | meaning | allowed | default |\n|---|---|---|---|---|\n";
    for (const Key& key : table.keys)
      text +=
          fmt::format("| `{}` | {} | {} | {} | {} |\n", key.name, std::visit(TypeName(), key.value),
                      key.doc, allowed(key), default_of(key));
  }
  return text;
}

}  // namespace pennon

#include "common/case/case_difference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "common/case/document.hpp"
#include "common/case/echo.hpp"

namespace pennon {
namespace {

using Values = std::map<std::string, std::string>;

void collect(const toml::table& table, const std::string& prefix, Values& values) {
  for (const auto& [name, node] : table) {
    const std::string key =
        prefix.empty() ? std::string(name.str()) : fmt::format("{}.{}", prefix, name.str());
    if (const toml::table* inner = node.as_table()) {
      collect(*inner, key, values);
      continue;
    }
    values[key] = toml_of(node);
  }
}

Values values_of(std::string_view text, const std::string& name) {
  Values values;
  collect(parse_document(text, name).root, "", values);
  return values;
}

std::optional<std::string> value_in(const Values& values, const std::string& key) {
  const auto found = values.find(key);
  return found == values.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

std::string CaseDifference::text() const {
  const auto said = [](const std::optional<std::string>& value) {
    return value ? shortened(*value) : "not set";
  };
  return fmt::format("{} = {} there, {} here", key, said(there), said(here));
}

std::vector<CaseDifference> case_differences(
    std::string_view there, const std::string& name_there, std::string_view here,
    const std::function<bool(const std::string& key)>& is_wanted) {
  const Values its = values_of(there, name_there), ours = values_of(here, "the case");
  Values all = its;
  all.insert(ours.begin(), ours.end());
  std::vector<CaseDifference> found;
  for (const auto& [key, value] : all) {
    if (is_wanted && !is_wanted(key)) continue;
    CaseDifference difference{key, value_in(its, key), value_in(ours, key)};
    if (difference.there != difference.here) found.push_back(std::move(difference));
  }
  return found;
}

std::string text_of(const std::vector<CaseDifference>& differences) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t k = 0; k < std::min(differences.size(), most); ++k)
    text += (k == 0 ? "" : "; ") + differences[k].text();
  if (differences.size() > most) text += fmt::format("; and {} more", differences.size() - most);
  return text;
}

}  // namespace pennon

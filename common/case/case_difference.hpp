/// In what two cases differ, key by key.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pennon {

struct CaseDifference {
  std::string key;                   ///< "flag.mu"
  std::optional<std::string> there;  ///< its value in the other case; none: it is not set there
  std::optional<std::string> here;

  /// "flag.mu = 0.1 there, 0.2 here".
  std::string text() const;
};

/// The keys in which two resolved cases (schema.hpp) differ, in the order of their names; values as
/// TOML. `is_wanted` says of which keys; without it all. Throws InputError, with `name_there`,
/// where the other is not TOML.
std::vector<CaseDifference> case_differences(
    std::string_view there, const std::string& name_there, std::string_view here,
    const std::function<bool(const std::string& key)>& is_wanted = {});

/// All of them in one sentence without its end: "flag.mu = 0.1 there, 0.2 here; and 3 more".
std::string text_of(const std::vector<CaseDifference>&);

}  // namespace pennon

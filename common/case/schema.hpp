/// What a case file may contain: tables of keys, each declared once, where its struct is, with its
/// doc line, unit or definition, range and default. From these declarations come the reader, the
/// resolved echo, the list of known names for misspelt ones, and the reference in docs/.
///
/// A key is bound to a variable; the variable's value at declaration is the default.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "common/case/range.hpp"
#include "common/case/sweep.hpp"

namespace pennon {

/// A key whose value is one of a few names, bound to an enum.
struct Choice {
  std::vector<std::string> names;
  std::function<void(std::size_t)> choose;
  std::function<std::optional<std::size_t>()> chosen;  ///< none when the key is unset
};

using Binding =
    std::variant<double*, std::optional<double>*, std::int64_t*, std::optional<std::int64_t>*,
                 bool*, std::string*, std::array<double, 3>*, std::vector<double>*,
                 std::vector<std::int64_t>*, std::vector<std::string>*, std::optional<Sweep>*,
                 Choice>;

struct Key {
  std::string name;
  Binding value;
  std::string doc;         ///< one line: meaning, unit or definition
  Range range = any_sign;  ///< of each number in it
  bool is_required = false;
  std::string default_text = {};        ///< said instead of the bound value, e.g. "2 pi/gamma"
  std::vector<std::string> known = {};  ///< what a text or each text of a list may be; any if empty
};

struct Table {
  std::string name;  ///< dotted: "lsa.map"
  std::string doc;
  bool* is_given = nullptr;  ///< set when the case has this table
  std::vector<Key> keys = {};

  /// Declares a key; returns the table, for the next one.
  Table& key(Key declared) {
    keys.push_back(std::move(declared));
    return *this;
  }
};

struct Schema {
  std::deque<Table> tables;  ///< a deque: the references table() returns stay valid

  Table& table(std::string name, std::string doc, bool* is_given = nullptr) {
    tables.push_back({std::move(name), std::move(doc), is_given});
    return tables.back();
  }
};

/// Binds an enum whose values, in order, have these names.
template <class Enum>
Choice choice(Enum& target, std::vector<std::string> names) {
  return {std::move(names), [&target](std::size_t i) { target = static_cast<Enum>(i); },
          [&target]() -> std::optional<std::size_t> { return static_cast<std::size_t>(target); }};
}
template <class Enum>
Choice choice(std::optional<Enum>& target, std::vector<std::string> names) {
  return {std::move(names), [&target](std::size_t i) { target = static_cast<Enum>(i); },
          [&target]() -> std::optional<std::size_t> {
            if (!target) return std::nullopt;
            return static_cast<std::size_t>(*target);
          }};
}

/// The bound values as a case file with every key: read again, it gives the same values bit for
/// bit. Unset optional keys are left out; tables that the case did not have, too.
std::string resolved_text(const Schema&);

/// The reference of the case file, in Markdown, from the declarations.
std::string reference_text(const Schema&);

}  // namespace pennon

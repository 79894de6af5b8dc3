/// The TOML document of a case with the place of every key, overrides included.
#pragma once

#include <toml++/toml.h>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "common/errors.hpp"

namespace pennon {

struct Document {
  toml::table root;
  std::string name;  ///< of the file, for messages
  std::map<const toml::node*, std::string> override_places = {};
  std::vector<InputFault> refused_overrides = {};

  /// Where a node stands: "file:line", or "--set table.key=value".
  std::string place(const toml::node& node) const;
};

/// The document of a text. Throws InputError where the text is not TOML, holds a NUL byte, or has a
/// name of more than 16 parts.
Document parse_document(std::string_view text, const std::string& name);

/// Puts one override, "table.key=value", into the document. A value that is not TOML is taken as
/// text. An override without this form, or one that would put a key into a value, is added to
/// `refused_overrides`.
void apply_override(Document& document, const std::string& assignment);

}  // namespace pennon

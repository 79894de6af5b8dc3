/// What the user wrote in a case, as messages show it.
#pragma once

#include <toml++/toml.h>
#include <string>

namespace pennon {

/// The text, cut between two letters and with "..." behind it where it is longer than 60 bytes.
std::string shortened(const std::string& text);

/// A value as TOML; numbers with as few digits as read back to the same bits.
std::string toml_of(double);
std::string toml_of(const toml::node&);

/// A value on one line, as TOML, shortened.
std::string echo(const toml::node& node);

/// A name, shortened: in quotes, with its control characters escaped, unless it is bare.
std::string echo(const std::string& name);

/// The kind of a value in words: "a table", "a list", "a text", "an integer", "a number".
std::string kind_of(const toml::node& node);

}  // namespace pennon

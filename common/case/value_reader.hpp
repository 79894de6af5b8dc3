/// Reads the value of one key of a case into the variable that the schema binds to it.
#pragma once

#include <toml++/toml.h>
#include <string>
#include <vector>

#include "common/case/schema.hpp"

namespace pennon {

/// Reads `node` into the variable of `key`. Returns what is wrong with the value, each fault a
/// sentence without its subject, which is the key's name: "must be > 0, but is -1". The variable
/// keeps its value where there is a fault.
std::vector<std::string> read_value(const Key& key, const toml::node& node);

}  // namespace pennon

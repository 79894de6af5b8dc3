/// A fault of one key, in the form of all such sentences.
#pragma once

#include <string>

#include "common/case/case_reader.hpp"

namespace pennon {

/// "dns.dt = 2 makes ...": the key's name opens the sentence, and its place is where it stands.
inline void about_key(Faults& faults, const std::string& key, const std::string& what) {
  faults.about(key, key + " " + what);
}

}  // namespace pennon

/// Which pennon this is: version, commit, and the libraries it runs on.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace pennon {

std::string version();  ///< "0.1.0"
std::string commit();   ///< of the sources built, "-dirty" appended where they were changed

/// Name and version of each library, of the one loaded where it can tell.
std::vector<std::pair<std::string, std::string>> library_versions();

}  // namespace pennon

/// Where the key of a figure stands: inside, in the first corner that is free of data, else below.
#pragma once

#include <string>

#include "analysis/drawing/frame.hpp"

namespace pennon::analysis {

/// gnuplot's command that places the key.
std::string key_command(const Figure&, const Frame&);

}  // namespace pennon::analysis

#pragma once

#include <functional>

namespace pennon::dns {

/// z = zeta(x, y) of a flag's displacement: (5.1), or a normal mode.
using ShapeFunction = std::function<double(double x, double y)>;

}  // namespace pennon::dns

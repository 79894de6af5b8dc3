/// A global mode in the steady flow past the flat flag, on the grid of the simulation that starts
/// in it. modes/global finds it; docs/theory/global-modes.md.
#pragma once

#include <array>
#include <complex>
#include <vector>

#include "dns/grid/field.hpp"

namespace pennon::dns {

/// Steady flow + Re[mode exp(i k_x x + lambda t)]. Scales L, V, rho_f.
struct FlowMode {
  std::complex<double> lambda;
  double k_x = 0;
  /// The steady flow in a plane: velocity along y, z and, with a span or cross-flow, x; pressure.
  std::vector<Field<double>> steady_u;
  Field<double> steady_p;
  std::vector<bool> is_inflow;  ///< of the outer faces
  /// Where the nodes of a station are in the steady flow, from the leading edge: x less that of the
  /// station, and y.
  std::vector<std::array<double, 2>> flag;
  std::vector<Field<std::complex<double>>> u;  ///< at points that move with the grid
  Field<std::complex<double>> p;
  std::vector<std::complex<double>> zeta, zeta_t;  ///< of those nodes, along z; zeta_t = d zeta/dt

  FlowMode(const Extent& plane, int components)
      : steady_u(static_cast<std::size_t>(components), Field<double>(plane)),
        steady_p(plane),
        u(steady_u.size(), Field<std::complex<double>>(plane)),
        p(plane) {}
};

}  // namespace pennon::dns

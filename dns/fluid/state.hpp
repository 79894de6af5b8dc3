/// The state of the fluid: what is advanced, saved and restarted.
#pragma once

#include <vector>

#include "dns/grid/elliptic_grid.hpp"
#include "dns/grid/field.hpp"

namespace pennon::dns {

struct FluidState {
  double t = 0;
  double previous_dt = 0;               ///< 0: the next step is the first
  std::vector<Field<double>> u;         ///< velocity: y, z and, where the case has it, x
  std::vector<Field<double>> u_last;    ///< one step before
  std::vector<Field<double>> u_change;  ///< what the last prediction added to its extrapolation:
                                        ///< the next solver's guess
  Field<double> p, p_last;
  std::vector<Displacement<double>> grid;  ///< now, one and two steps before
  std::vector<bool> is_inflow;             ///< of the outer faces, plane by plane
};

}  // namespace pennon::dns

/// What the fluid depends on, and how exactly it is computed. Scales: L, V, rho_f.
#pragma once

namespace pennon::dns {

struct FluidParameters {
  double Re = 1000;
  double U = 0;     ///< cross-flow, over V
  double ramp = 0;  ///< time over which the stream rises from rest, in L/V; 0: it is there at once
};

struct FluidTolerances {
  double pressure = 1e-6;  ///< root mean square error of the pressure left by a step, rho_f V^2
  double velocity = 1e-7;  ///< the same of the velocity, V
  double grid = 1e-5;      ///< last change of a corner, L
  int most_grid_passes = 20;
};

}  // namespace pennon::dns

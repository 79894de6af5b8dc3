/// The steady flow past the flat flag, at which a step of the simulation changes nothing: Newton's
/// method on PlaneEquations with their exact Jacobian and a sparse direct solver, from a small
/// Reynolds number upwards.
#pragma once

#include <vector>

#include "modes/global/equations/half_plane.hpp"

namespace pennon::modes::global {

struct BaseFlow {
  PlaneParameters parameters;
  PlaneFlow<double> q;
  std::vector<bool> is_inflow;   ///< of the outer faces
  SegmentForces<double> forces;  ///< on the flag's segments, per unit span
  std::vector<double> tension;   ///< at its nodes: what pulls downstream of them, rho_f V^2 L
  double drag_coefficient = 0;   ///< both sides, on 1/2 rho_f V^2 L
  double residual = 0;           ///< largest of a cell's equations over its volume
  int iterations = 0;            ///< of Newton's method, at all Reynolds numbers
};

/// `components` of the velocity: 3 where a disturbance varies along the span. Throws SolverError
/// with the Reynolds number at which Newton's method failed.
BaseFlow base_flow(const OGrid&, const PlaneParameters&, int components);

/// The same from a flow nearby, at another Reynolds number or with another number of components:
/// Newton's method at once, and from the uniform stream where that fails.
BaseFlow base_flow(const OGrid&, const PlaneParameters&, int components, const BaseFlow& nearby);

/// The largest residual of a cell's equations over its volume, at a flow about a flag at rest.
double largest_residual(const OGrid&, const PlaneParameters&, PlaneFlow<double> q,
                        const std::vector<bool>& is_inflow);

}  // namespace pennon::modes::global

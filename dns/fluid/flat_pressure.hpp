/// The pressure's operator on the flat grid, for one wavenumber k along the span: the integral of
/// lap p over each cell as the stencils take it, p = 0 at the outer boundary, no flux through the
/// flag. docs/theory/fluid.md derives it.
#pragma once

#include "dns/grid/o_grid.hpp"
#include "dns/numerics/separable_solver.hpp"

namespace pennon::dns {

class FlatPressure {
 public:
  /// `k` in 1/L.
  FlatPressure(const OGrid&, double k);

  /// Solves in place: n_rho rows of n_theta integrals of lap p over the cells become pressures.
  void solve(double* values);

 private:
  SeparableSolver solver_;
  // The integrals over sR_j sTheta_i are the operator's Kronecker sum.
  Eigen::Array<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> inverse_area_;
};

}  // namespace pennon::dns

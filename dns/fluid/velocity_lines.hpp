/// The preconditioner of the fluid's velocity solver: its operator on the lines theta = const, with
/// first-order upwind convection and without the neighbours along theta and x, inverted exactly.
#pragma once

#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"

namespace pennon::dns {

class VelocityLines {
 public:
  explicit VelocityLines(const Extent&);

  /// For d/dt = `weight` u, the convection C_s, C_t in cells along s and t, and the viscosity
  /// nu = 1/Re; eliminates from the flag outward.
  void prepare(const Metrics<double>&, const Field<double>& C_s, const Field<double>& C_t,
               double weight, double nu);
  /// `components` components of packed cells, one behind the other.
  void invert(std::size_t components, const double* in, double* out) const;

 private:
  Field<double> lower_, pivot_, upper_;
};

}  // namespace pennon::dns

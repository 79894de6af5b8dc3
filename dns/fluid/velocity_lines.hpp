/// The preconditioner of the fluid's velocity solver: its operator on the lines theta = const, with
/// first-order upwind convection and without the neighbours along theta and x, inverted exactly.
#pragma once

#include "dns/grid/field.hpp"
#include "dns/grid/metrics.hpp"

namespace pennon::dns {

class VelocityLines {
 public:
  explicit VelocityLines(const Extent&);

  /// Factors the operator, from the flag outward: `weight` is that of the new velocity in its time
  /// derivative, C_s and C_t carry it, in cells along s and t per time, and nu = 1/Re.
  void prepare(const Metrics<double>&, const Field<double>& C_s, const Field<double>& C_t,
               double weight, double nu);
  /// Solves with the factors: `in` and `out` hold `components` components of packed cells, one
  /// behind the other.
  void invert(std::size_t components, const double* in, double* out) const;

 private:
  Field<double> lower_, pivot_, upper_;
};

}  // namespace pennon::dns

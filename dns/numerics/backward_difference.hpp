/// The second-order backward difference of (3.2) for steps of unequal length:
///
///   df/dt at n + 1 = (next f^{n+1} + last f^n + before f^{n-1}) + O(dt^2),
///
/// and the value at n + 1 extrapolated from n and n - 1. The first step is of first order.
#pragma once

namespace pennon::dns {

struct BackwardDifference {
  double next, last, before;                ///< weights of f in the derivative
  double guess_last = 1, guess_before = 0;  ///< weights of f in the extrapolated value

  /// `previous_dt` 0: there is no step before.
  BackwardDifference(double dt, double previous_dt) {
    if (previous_dt == 0) {
      next = 1 / dt;
      last = -1 / dt;
      before = 0;
      return;
    }
    const double ratio = dt / previous_dt;
    next = (1 + 2 * ratio) / (1 + ratio) / dt;
    last = -(1 + ratio) / dt;
    before = ratio * ratio / (1 + ratio) / dt;
    guess_last = 1 + ratio;
    guess_before = -ratio;
  }

  template <class Value>
  Value derivative(const Value& f_next, const Value& f_last, const Value& f_before) const {
    return next * f_next + last * f_last + before * f_before;
  }
};

}  // namespace pennon::dns

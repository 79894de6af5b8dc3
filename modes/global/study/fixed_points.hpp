/// Disturbances at fixed points of those that are known at points that move with the grid
/// (mode_fields.hpp): f' = f - (d . grad) f_0, f_0 of the steady flow, d the displacement of the
/// grid.
#pragma once

#include <complex>
#include <vector>

#include "modes/global/equations/coupled_operator.hpp"

namespace pennon::modes::global {

/// Derivatives of a field, which has its ghosts, along y and z.
template <class Scalar>
struct PlaneGradient {
  Field<Scalar> y, z;

  PlaneGradient(const dns::Metrics<Scalar>& metrics, const Field<Scalar>& f)
      : y(f.extent()), z(f.extent()) {
    dns::gradient<Scalar>(metrics, 0, f, nullptr, {nullptr, &y, &z});
  }
};

/// omega_x = dw/dy - dv/dz; the ghosts of v and w as PlaneEquations leave them.
template <class Scalar>
Field<Scalar> vorticity(const dns::Metrics<Scalar>& metrics, const PlaneFlow<Scalar>& q) {
  const PlaneGradient<Scalar> v(metrics, q.u[dns::along_y]), w(metrics, q.u[dns::along_z]);
  Field<Scalar> omega = w.y;
  for (std::size_t k = 0; k < omega.values().size(); ++k) omega.values()[k] -= v.z.values()[k];
  return omega;
}

/// The displacement of the corners, or their velocity, as the flag's free nodes move by the
/// unknowns of q from the index `first` on.
Displacement<std::complex<double>> displacement_of(const CoupledOperator&,
                                                   const Eigen::VectorXcd& q, Eigen::Index first);

class FixedPoints {
 public:
  FixedPoints(const OGrid&, const BaseFlow&);

  /// The steady flow with its ghosts, and its vorticity.
  const PlaneFlow<double>& base() const { return base_; }
  const Field<double>& base_vorticity() const { return base_vorticity_; }

  /// f' of a field of the flow, counted as PlaneFlow does.
  Field<std::complex<double>> of_field(int field, const Field<std::complex<double>>& f,
                                       const Displacement<std::complex<double>>& d) const;
  Field<std::complex<double>> of_vorticity(const Field<std::complex<double>>& f,
                                           const Displacement<std::complex<double>>& d) const;

 private:
  PlaneFlow<double> base_;
  Field<double> base_vorticity_;
  std::vector<PlaneGradient<double>> gradients_;  // of the fields, then of the vorticity
};

}  // namespace pennon::modes::global

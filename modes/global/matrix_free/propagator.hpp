/// The propagator of the simulation over a time T: what becomes of a small sinuous perturbation of
/// a flat flag in its symmetric flow, found by running the simulation itself. The eigenvalues of
/// this linear map are exp(lambda T) of the global modes, but for the errors of the time step.
///
/// A perturbation is sinuous if the reflection z -> -z turns it into its opposite: zeta and w stay,
/// v and p change their sign. Of the state after the time T the sinuous part is taken. The
/// symmetric part drops out, and with it whatever the base flow itself still changes by, so that
/// the map is linear up to the square of the perturbation. With S_T the state to which the
/// simulation takes a state in the time T,
///
///   Phi q = sinuous part of S_T(base + a q)/a,       a = amplitude/max |q|.
///
/// With a span, perturbations vary as cos(2 pi x/S): the mean over the planes is taken out too.
///
/// The numbers q are those that the next step depends on: velocity and pressure at two times, the
/// grid at two times, the flag's positions and velocities at two times, the reduced jump at two.
#pragma once

#include <Eigen/Core>

#include "dns/coupling/coupling.hpp"

namespace pennon::dns {

struct PropagatorSettings {
  double dt = 0.002;
  int steps = 500;
  double amplitude = 1e-5;  ///< largest number of the perturbation, in L, V and rho_f V^2
};

template <int dim>
class Propagator {
 public:
  /// `base`: a flat flag in its developed flow, after two steps of settings.dt at least; its own
  /// sinuous part is taken out. On one rank.
  Propagator(Coupling<dim>&, CoupledState<dim> base, const PropagatorSettings&);

  Eigen::Index size() const { return size_; }
  double time() const { return settings_.dt * settings_.steps; }

  /// out = Phi in. Throws SolverError as Coupling::advance() does.
  void apply(const double* in, double* out) { propagate(in, out, settings_.steps); }
  /// The same over one step. It tells eigenvalues lambda apart whose frequencies differ by a
  /// multiple of 2 pi/T.
  void apply_one_step(const double* in, double* out) { propagate(in, out, 1); }

  /// A perturbation to begin with: the flag has an upward velocity that grows as y^2 along the
  /// chord.
  Eigen::VectorXd thrown_flag() const;

 private:
  void propagate(const double* in, double* out, int steps);
  Eigen::VectorXd packed(const CoupledState<dim>&) const;
  void add(double factor, const double* q, CoupledState<dim>&) const;
  void keep_sinuous_part(Eigen::VectorXd& q) const;

  Coupling<dim>& coupling_;
  CoupledState<dim> base_;
  PropagatorSettings settings_;
  Eigen::Index size_ = 0;
};

}  // namespace pennon::dns

/// The linearised simulation over a time: what becomes of a small sinuous perturbation of a flat
/// flag in its symmetric flow, by running the simulation itself. Matrix-free: the eigenvalues of
/// this map are exp(lambda T) of the global modes, with the errors of the time step in them.
///
/// A perturbation is sinuous if the reflection z -> -z turns it into its opposite: zeta and w stay,
/// v and p change their sign. Of the state after the time the sinuous part is taken; the symmetric
/// part, and with it whatever the base flow itself still changes by, drops out, so that the map is
/// linear up to the square of the perturbation:
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
  /// The same over one step: tells eigenvalues apart that agree but for whole turns.
  void apply_one_step(const double* in, double* out) { propagate(in, out, 1); }

  /// A flag thrown upward, more the nearer to the trailing edge: a vector to begin with.
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

/// A flag and the flow about it, as the tests drive them.
#pragma once

#include <cmath>

#include "dns/coupling/coupling.hpp"
#include "dns/run/initial_shape.hpp"

namespace pennon::test {

struct CoupledCase {
  dns::OGridSettings grid{.n_rho = 32, .n_theta = 64, .R = 8, .wall_spacing = 0.02};
  dns::FluidParameters fluid{.Re = 1000};
  dns::FluidTolerances tolerances{.pressure = 1e-8, .velocity = 1e-9, .grid = 1e-7};
  dns::FlagMaterial flag{.mu = 0.125, .K_B = 1e-4, .K_S = 500, .damping = 0.02};
  dns::Edge leading_edge = dns::Edge::pinned;
  dns::CouplingSettings coupling{.tolerance = 1e-7};
  int planes = 1;
  double span = 1;
};

inline dns::FlagMesh coupled_mesh(const CoupledCase& settings, const dns::OGrid& grid) {
  const dns::EdgeConditions edges{.leading = settings.leading_edge};
  if (settings.planes == 1) return {dns::coupled_chord(grid), edges};
  return {dns::coupled_chord(grid), settings.planes, settings.span, edges};
}

template <int dim>
class CoupledRun {
 public:
  explicit CoupledRun(const CoupledCase& settings, const dns::ShapeFunction& zeta)
      : fluid_(dns::OGrid(settings.grid), dns::Span(settings.planes, settings.span), settings.fluid,
               settings.tolerances),
        flag_(coupled_mesh(settings, fluid_.grid()), settings.flag),
        coupling_(fluid_, flag_, Eigen::Matrix<double, dim, 1>::Zero(), settings.coupling) {
    state_ = coupling_.start(dns::initial_shape<dim>({}, zeta, flag_.mesh()), 0);
  }

  dns::Fluid& fluid() { return fluid_; }
  const dns::Flag<dim>& flag() const { return flag_; }
  dns::Coupling<dim>& coupling() { return coupling_; }
  dns::CoupledState<dim>& state() { return state_; }

  dns::CoupledStepSummary step(double dt) { return coupling_.advance(state_, dt); }
  /// Equal steps of about dt up to t.
  void run_to(double t, double dt) {
    const auto steps = std::lround((t - state_.fluid.t) / dt);
    const double h = (t - state_.fluid.t) / static_cast<double>(steps);
    for (long n = 0; n < steps; ++n) step(h);
  }
  /// The start: steps that grow from a twentieth of dt by a fifth each.
  void start_steps(double dt) {
    for (double h = dt / 20; h < dt; h *= 1.2) step(h);
  }

  /// z of the trailing edge at a station.
  double trailing_edge(int station = 0) const {
    return state_.flag.x(dim - 1, flag_.mesh().index(station, flag_.mesh().chord_nodes() - 1));
  }

 private:
  dns::Fluid fluid_;
  dns::Flag<dim> flag_;
  dns::Coupling<dim> coupling_;
  dns::CoupledState<dim> state_;
};

}  // namespace pennon::test

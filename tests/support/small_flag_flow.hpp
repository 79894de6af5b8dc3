/// A small flag in a small flow, for what is asked of the flag's own equations: seconds for all.
#pragma once

#include "dns/fluid/equations/wall_faces.hpp"
#include "modes/global/equations/coupled_operator.hpp"
#include "modes/global/study/settings.hpp"

namespace pennon::test {

/// Its grid, as a case would have it.
inline constexpr modes::global::Discretisation small_discretisation{.n_rho = 12,
                                                                    .n_theta = 24,
                                                                    .n_x = 40,
                                                                    .R = 3,
                                                                    .wall_spacing = 0.1,
                                                                    .wake_clustering = 0,
                                                                    .dt = 0.015};

struct SmallFlow {
  dns::OGrid grid;
  double k_x, U;
  modes::global::BaseFlow base;

  explicit SmallFlow(int n_theta, double its_k_x = 0, double its_U = 0)
      : grid({.n_rho = 12, .n_theta = n_theta, .R = 3, .wall_spacing = 0.1}),
        k_x(its_k_x),
        U(its_U),
        base(modes::global::base_flow(grid, {.Re = 200, .U = its_U, .dt_of_pressure = 0.01},
                                      its_k_x != 0 ? 3 : 2)) {}
  modes::global::FlagOperator flag(double K_B, double mu = 1) const {
    return modes::global::flag_operator(dns::coupled_chord(grid), dns::Edge::pinned,
                                        {.mu = mu, .K_B = K_B}, base.forces, k_x, 40);
  }
  modes::global::CoupledOperator coupled(double K_B, double mu = 1) const {
    return modes::global::coupled_operator(grid, base, flag(K_B, mu), k_x);
  }
};

}  // namespace pennon::test

/// Asks two of pennon's libraries: for the added mass of a plate that plunges in a fluid at rest,
/// pi/4 by theory, and whether a flag flutters.
#include <Eigen/Core>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <vector>

#include "dns/coupling/added_mass.hpp"
#include "dns/coupling/coupling.hpp"
#include "dns/grid/o_grid.hpp"
#include "lsa/added_mass.hpp"
#include "lsa/dispersion.hpp"

namespace {

double added_mass_of_plunging() {
  const pennon::dns::OGrid grid({.n_rho = 24, .n_theta = 48, .R = 8, .wall_spacing = 0.03});
  const std::vector<double> chord = pennon::dns::coupled_chord(grid);
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(chord.size()) - 1);
  for (Eigen::Index s = 0; s < lengths.size(); ++s)
    lengths[s] = chord[static_cast<std::size_t>(s) + 1] - chord[static_cast<std::size_t>(s)];
  return lengths.dot(pennon::dns::flat_jump_response(grid, 0) * lengths);
}

bool flutters(double mu) {
  using namespace pennon::lsa;
  const Point point{.mu = mu, .Re = 1000, .k_y = 2 * std::numbers::pi, .nu_s = 0.3};
  const double c_m = added_mass(AddedMass::two_d, {}, point.k_x, point.k_y);
  return solve(coefficients(point, c_m, tension_times_sqrt_Re({}), false, false), Form::consistent)
      .is_unstable();
}

}  // namespace

int main() {
  const double ratio = added_mass_of_plunging() / (std::numbers::pi / 4);
  std::printf("added mass over pi/4: %.4f; flutters at mu = 0.1: %d, at 0.001: %d\n", ratio,
              flutters(0.1), flutters(0.001));
  return std::abs(ratio - 1) < 0.02 && flutters(0.1) && !flutters(0.001) ? 0 : 1;
}

/// Shapes of a flag on given modes (given_modes.hpp): the amplitudes a_j(t_m) for which
///
///     |z_m - Re sum_j a_j(t_m) Y_j exp(i k_j x)|
///
/// is least in the norm of the data, with all modes together, so that they need not be orthogonal.
/// What lies in their span is found to roundoff times the condition number of the problem.
#pragma once

#include "analysis/decomposition/bands.hpp"
#include "analysis/decomposition/given_modes.hpp"

namespace pennon::decomposition {

struct Projection {
  std::vector<GivenMode> modes;
  Eigen::MatrixXcd a;           ///< modes x M
  Eigen::VectorXd rest;         ///< |what is left| at each time, in the data's norm
  Eigen::VectorXd whole;        ///< |z| at each time
  double condition_number = 0;  ///< of the problem, its columns of norm 1

  /// The root of the mean square of what is left, over that of all.
  double error() const { return whole.norm() > 0 ? rest.norm() / whole.norm() : 0; }
};

/// Growth and angular frequency of an amplitude: the slopes of log |a| and of the phase by straight
/// lines, with the standard deviations of their fits. Of a standing mode there is no phase.
struct Slopes {
  double growth = 0, growth_error = 0, omega = 0, omega_error = 0;
};
Slopes slopes_of(const std::vector<double>& t, const Eigen::VectorXcd& a);

/// Throws InputError where the data have no y, are at too few nodes, or lie so that some sum of
/// modes vanishes at all of them.
Projection project(const Bands<double>&, std::vector<GivenMode>);

}  // namespace pennon::decomposition

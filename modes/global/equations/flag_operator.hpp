/// The transverse motion of the flag about the flat equilibrium in the steady flow,
///
///   M d^2 zeta/dt^2 + K zeta = force,
///
/// for displacements that vary as exp(i k_x x): mass and tangent of the simulation's own flag
/// (dns/flag/flag.hpp), stretched by the friction on it. K holds the tension T(y) along the chord,
/// nu_s T along the span, the shear that a cross-flow leaves in the flag (imaginary: it pulls a
/// crest along the span), and the bending of Kirchhoff's plate with its natural conditions. To
/// first order the flat flag does not stretch as it bends, so neither K_S nor the damping enters
/// but by the equilibrium.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dns/flag/flag.hpp"
#include "modes/global/equations/plane_equations.hpp"

namespace pennon::modes::global {

/// M and K for the nodes of a station that are not held, n of them, from the leading edge. Both are
/// per unit span, and so is the force.
struct FlagOperator {
  Eigen::VectorXd mass;        ///< the diagonal of M, n numbers
  Eigen::MatrixXcd stiffness;  ///< K, n x n and Hermitian; real without a cross-flow
  /// The equilibrium positions of all nodes of a station, held ones included: x less that of the
  /// station (0 without a span), and y.
  std::vector<std::array<double, 2>> nodes = {};
};

/// The positions at which the flat flag is in equilibrium under the friction of the steady flow,
/// dim x nodes. Throws SolverError where the friction does not hold the flag flat.
template <int dim>
dns::NodeVectors<dim> equilibrium(const dns::Flag<dim>&, const SegmentForces<double>& forces);

/// M and K of the flag whose nodes have these y (`chord`), the first of them held, under the forces
/// of the steady flow on its segments. With k_x != 0, `stations` is the number of stations in one
/// wave of the simulation, whose finite differences between stations K contains. Throws as
/// equilibrium() does.
FlagOperator flag_operator(const std::vector<double>& chord, dns::Edge leading_edge,
                           const dns::FlagMaterial&, const SegmentForces<double>& forces,
                           double k_x, int stations);

}  // namespace pennon::modes::global

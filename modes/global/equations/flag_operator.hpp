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

/// Mass and stiffness of the nodes that are not held, from the leading edge; per unit span.
struct FlagOperator {
  Eigen::VectorXd mass;
  Eigen::MatrixXcd stiffness;  ///< Hermitian; real without a cross-flow
  /// Where all nodes are in the equilibrium: x less that of the station, 0 without a span, and y.
  std::vector<std::array<double, 2>> nodes = {};
};

/// The flat flag at rest under the friction of the steady flow, dim x nodes. Throws SolverError
/// where it does not carry it flat.
template <int dim>
dns::NodeVectors<dim> equilibrium(const dns::Flag<dim>&, const SegmentForces<double>& forces);

/// `chord`: the nodes' y; the leading one is held. `forces`: of the steady flow on the segments.
/// With k_x != 0 the flag has `stations` spanwise nodes in a wave, as the simulation has: its
/// differences along the span are part of K. Throws as equilibrium() does.
FlagOperator flag_operator(const std::vector<double>& chord, dns::Edge leading_edge,
                           const dns::FlagMaterial&, const SegmentForces<double>& forces,
                           double k_x, int stations);

}  // namespace pennon::modes::global

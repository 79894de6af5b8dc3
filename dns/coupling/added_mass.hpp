/// The added mass of the flag: the pressure that its acceleration makes in the fluid at once.
///
/// The flag's segments, between neighbouring nodes along the chord at each station of the span, are
/// the faces of the fluid's grid, one above and one below. An acceleration a of the nodes makes
/// fluid pass through them at the rate phi = A . (a_s + a_{s+1})/2, A a segment's area vector, and
/// the flat fluid answers with the pressure jump (below minus above) - Pi phi: for each wavenumber
/// along the span a matrix, found once by FlatPressure. The force of a jump on the nodes is A times
/// it, half to each. So M_a = E^T Pi E, E from nodes to rates.
///
/// Scales: L, V, rho_f; per unit of x, and forces on the nodes of a flag with a span times its
/// share.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "dns/flag/added_inertia.hpp"
#include "dns/flag/mesh.hpp"
#include "dns/flag/step.hpp"
#include "dns/flag/tangent_matrix.hpp"
#include "dns/fluid/equations/wall_faces.hpp"
#include "dns/grid/o_grid.hpp"
#include "dns/numerics/krylov.hpp"

namespace pennon::dns {

/// Pi for one wavenumber k along the span; symmetric but for the wall's extrapolation.
Eigen::MatrixXd flat_jump_response(const OGrid&, double k);

/// A number for each segment: a row for each station, a column for each segment from the leading
/// edge.
using SegmentValues = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <int dim>
class AddedMass final : public AddedInertia<dim> {
 public:
  /// The mesh's chordwise nodes are the grid's corners on the flag, its stations equal the planes.
  AddedMass(const OGrid&, const FlagMesh&, double mu);

  /// The area vectors A of the segments, dim x (stations segments), as the upper faces have them.
  void set_areas(const NodeVectors<dim>& areas) { areas_ = areas; }

  /// Pi phi for an acceleration of the nodes.
  void find_jump(const NodeVectors<dim>& acceleration, SegmentValues& jump) const;
  /// Adds A times the jump to the nodes' forces.
  void add_force(const SegmentValues& jump, NodeVectors<dim>& forces) const;
  /// Subtracts M_a a.
  void subtract_force(const NodeVectors<dim>& acceleration,
                      NodeVectors<dim>& forces) const override;

  /// Solves (K + mass_factor M_a) x = r in place, by GMRES to `solution_error`. Its preconditioner
  /// is K's factors, of this or an earlier K, and the added mass of a flat flag without stiffness:
  ///
  ///   K^-1 (1 + M_a M^-1)^-1 = K^-1 (1 - E^T (1 + Pi E M^-1 E^T)^-1 Pi E M^-1).
  ///
  /// Returns the iterations.
  int solve(TangentMatrix<dim>& K, double mass_factor, NodeVectors<dim>& r) override;

  static constexpr double solution_error = 1e-4;

 private:
  void multiply_waves(const std::vector<Eigen::MatrixXd>& matrices, SegmentValues& values) const;
  void find_flux(const NodeVectors<dim>& acceleration, SegmentValues& flux) const;
  void multiply(const double* in, double* out);
  void precondition(const double* in, double* out);

  int stations_, segments_;
  double share_;  // of the span, for a station
  NodeVectors<dim> areas_;
  std::vector<int> waves_;                 // of the rows of to_waves_
  Eigen::MatrixXd to_waves_;               // orthonormal, stations x stations
  std::vector<Eigen::MatrixXd> response_;  // Pi transposed, by the number of waves
  std::vector<Eigen::MatrixXd> preconditioner_;
  Eigen::RowVectorXd inverse_mass_;  // per area, of each node; 0 where the flag is held
  Krylov krylov_;
  TangentMatrix<dim>* tangent_ = nullptr;  // during solve()
  double mass_factor_ = 0;
  mutable NodeVectors<dim> vectors_;
  mutable SegmentValues coefficients_, products_;
};

}  // namespace pennon::dns

/// The added mass of the flag: the pressure that its acceleration makes in the fluid at once.
///
/// The flag's segments, between neighbouring nodes along the chord at each station, are the faces
/// of the fluid's grid, one above and one below (wall_faces.hpp). An acceleration a of the nodes
/// makes fluid pass through a segment at the rate phi = A . (a_s + a_{s+1})/2, A the segment's area
/// vector. The flat fluid answers with the pressure jump [p] = - Pi phi, [p] the pressure below
/// less that above: Pi is a matrix for each wavenumber along the span, found once by FlatPressure.
/// The force of a jump on a segment is A [p], half to each of its nodes. So M_a = E^T Pi E, where E
/// maps accelerations of the nodes to phi.
///
/// Scales: L, V, rho_f. All is per unit of x, but the forces on the nodes of a flag with a span are
/// those on the share of the span that belongs to a station.
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

/// Pi for one wavenumber k along the span, in 1/L: segments x segments, from phi to the pressure
/// above less that below, - [p]. It is symmetric but for the wall's extrapolation.
Eigen::MatrixXd flat_jump_response(const OGrid&, double k);

/// A number for each segment: a row for each station, a column for each segment along the chord,
/// from the leading edge.
using SegmentValues = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

template <int dim>
class AddedMass final : public AddedInertia<dim> {
 public:
  /// Preconditions: the mesh's chordwise nodes are the grid's corners on the flag
  /// (coupled_chord()), and it has as many stations as the fluid has planes. `mu` is the mass
  /// ratio.
  AddedMass(const OGrid&, const FlagMesh&, double mu);

  /// The area vectors A of the segments, dim x (stations times segments), as the upper faces have
  /// them.
  void set_areas(const NodeVectors<dim>& areas) { areas_ = areas; }

  /// Pi phi for an acceleration of the nodes: the pressure above less that below, which is - [p].
  void find_response(const NodeVectors<dim>& acceleration, SegmentValues& response) const;
  /// Adds A [p], half to each node of a segment, to the nodes' forces; [p] is below less above.
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

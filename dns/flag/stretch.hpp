/// The stretch energy of a flag, its forces and its tangent (section 3.2, (3.3) to (3.5)):
///
///   E_s = K_S/2 int int e_1^2 + e_2^2 + 2 nu_s e_1 e_2 + (1 - nu_s)/2 (x_1.x_2)^2 ds_1 ds_2
///
/// with the strains e_1 = |x_1| - 1, e_2 = |x_2| - 1 and the shear x_1.x_2; x_1 = dx/ds_1.
/// Discrete: e_1 and e_2 live on the segments between neighbouring nodes, e_1 e_2 and the shear in
/// the cells, from the means of their segments; second order, and only rigid motion is free of
/// energy. Damping (Kelvin-Voigt) adds K_S damping de/dt to the tension of each segment.
///
/// In two dimensions there are the chordwise segments only.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "dns/flag/material.hpp"
#include "dns/flag/mesh.hpp"
#include "dns/flag/step.hpp"
#include "dns/flag/tangent_matrix.hpp"

namespace pennon::dns {

template <int dim>
class Stretch {
 public:
  Stretch(const FlagMesh&, const StretchEnergy&);

  struct Energy {
    double two_d = 0;    ///< of e_1^2
    double three_d = 0;  ///< all that the span adds
  };
  Energy energy(const NodeVectors<dim>& x) const;

  /// Adds minus the gradient of the energy, and the damping's forces.
  void add_forces(const FlagStep<dim>&, NodeVectors<dim>& forces) const;
  /// Adds the derivative of minus these forces by step.end.
  void add_tangent(const FlagStep<dim>&, TangentMatrix<dim>&) const;
  /// The energy that the damping takes in a step, >= 0: exactly so with the discrete gradient, to
  /// second order otherwise.
  double dissipated(const NodeVectors<dim>& start, const NodeVectors<dim>& end, double dt) const;

  /// e_1, e_2 and the shear x_1.x_2 of each cell, from the means of its segments; 3 x elements, as
  /// PressureLoad counts them. In two dimensions e_1 of each segment, and nothing else.
  Eigen::Matrix3Xd strains(const NodeVectors<dim>& x) const;
  /// The least and greatest strain of all segments.
  std::pair<double, double> strain_range(const NodeVectors<dim>& x) const;

 private:
  using Vector = Eigen::Matrix<double, dim, 1>;
  using Block = Eigen::Matrix<double, dim, dim>;

  struct Segment {
    int from, to;
    bool is_chordwise;
    bool crosses_seam;  // the period lies between its nodes
    double h;           // length at rest
    double area;        // that it stands for
  };
  struct Cell {
    std::array<int, 4> nodes;     // 00, 01 (next along the chord), 10 (next along the span), 11
    std::array<int, 4> segments;  // 00-01, 10-11, 00-10, 01-11
    double area;
  };
  // A segment during a step.
  struct State {
    Vector direction;        // d strain/d(to), h times: mean difference over mean length
    Vector at_end;           // the same at the end: a unit vector
    double strain;           // that the tension answers
    double relative_length;  // mean length over h
    double strain_rate;      // that the damping answers
    Vector rate_by_end;      // d(strain rate)/d(to), h times
  };

  State state(const FlagStep<dim>&, const Segment&) const;
  void add_rate(const FlagStep<dim>&, const Segment&, State&) const;
  Vector difference(const NodeVectors<dim>& x, const Segment&) const;
  double strain(const NodeVectors<dim>& x, const Segment&) const;
  Vector mean_slope(const FlagStep<dim>&, const Cell&, int first, int second, bool at_end) const;
  struct Shear;
  Shear shear(const FlagStep<dim>&, const Cell&) const;
  void evaluate(const FlagStep<dim>&) const;

  double stiffness(const Segment&) const;

  StretchEnergy of_;
  double span_;
  std::vector<Segment> segments_;
  std::vector<Cell> cells_;
  mutable std::vector<State> states_;     // work space of one evaluation
  mutable std::vector<double> tensions_;  // energy per strain of each segment
};

}  // namespace pennon::dns

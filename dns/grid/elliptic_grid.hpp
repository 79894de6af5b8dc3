/// The O-grid about a displaced flag: in each plane x = const the corners r = (y, z) satisfy
///
///   |r_theta|^2 r_rhorho - 2 (r_rho . r_theta) r_rhotheta + |r_rho|^2 r_thetatheta = 0,
///
/// that is, rho and theta stay harmonic functions of y and z (Winslow 1966), with r given on the
/// flag and at rest on the outer boundary. It is solved for the displacement from the conformal
/// grid, which satisfies it, so that the derivatives of the latter are exact. Second order.
///
/// The solution is iterated. For a change delta = e1 r_rho + e2 r_theta the left side changes,
/// where it vanishes, by r_rho L e1 + r_theta L e2 with L e = |r_theta|^2 e_rhorho - 2 (r_rho .
/// r_theta) e_rhotheta + |r_rho|^2 e_thetatheta: rho and theta are harmonic, so that first
/// derivatives of e cancel. A pass resolves the residual in this frame, divides by (|r_rho|^2 +
/// |r_theta|^2)/2 and applies the inverse of d_rho^2 + d_theta^2. That contracts by
///   q = [(|r_rho|^2 - |r_theta|^2)^2 + 4 (r_rho . r_theta)^2]^1/2 / (|r_rho|^2 + |r_theta|^2) < 1
/// (Cordes 1956; Miranda & Talenti), 0 on the grid at rest. Anderson's acceleration combines the
/// passes after the second.
#pragma once

#include <array>

#include "dns/grid/field.hpp"
#include "dns/grid/o_grid.hpp"
#include "dns/numerics/anderson.hpp"
#include "dns/numerics/separable_solver.hpp"

namespace pennon::dns {

/// Of the corners, from the grid at rest. Row 0 is the flag's.
template <class Scalar>
struct Displacement {
  Field<Scalar> y, z;

  explicit Displacement(const Extent& extent) : y(extent), z(extent) {}
};

struct EllipticGridSummary {
  int passes = 0;
  double change = 0;      ///< of the last pass, largest, in L
  double least_area = 1;  ///< of a cell, over its area at rest; not positive where the grid folds
  double worst_y = 0, worst_z = 0;  ///< the middle of that cell, found if the grid folds
};

class EllipticGrid {
 public:
  explicit EllipticGrid(const OGrid&);

  /// Moves row 0 of a plane to the flag's displacement (n_theta numbers each), and the others along
  /// with it, less the farther they are.
  void move_wall(int plane, const double* y, const double* z, Displacement<double>&) const;

  /// Brings the corners of a plane into equilibrium with their row 0; what `displacement` holds is
  /// the first guess. Stops where a pass changes no corner by more than `tolerance`, or after
  /// `most_passes`: any smooth grid is a valid one, and the next step goes on from there. If the
  /// guess is extrapolated linearly from the last two steps, two passes a step keep the error as
  /// small as the guess's own, and smooth in time: being contracted by q twice, it cannot
  /// alternate.
  EllipticGridSummary relax(int plane, Displacement<double>& displacement, double tolerance,
                            int most_passes);

  /// The left side of the equation above, both components divided by (|r_rho|^2 + |r_theta|^2)/2,
  /// at the inner corners of a plane: rows 1 .. n_rho - 1 of n_theta, one behind the other.
  template <class Scalar>
  void residual(int plane, const Displacement<Scalar>& displacement, Scalar* y, Scalar* z) const;

  /// move_wall() and relax(); where that folds, from the grid at rest in small parts. If these fold
  /// too, `displacement` and the summary are those of the last part tried.
  EllipticGridSummary follow(int plane, const double* y, const double* z, Displacement<double>&,
                             double tolerance, int most_passes);

  /// The least ratio of a cell's area to its area at rest.
  double least_area(int plane, const Displacement<double>&) const;
  /// The largest ratio of the area of a cell at the flag to its area at rest: how much thicker it
  /// has become, since the flag hardly stretches.
  double largest_wall_area(int plane, const Displacement<double>&) const;

 private:
  struct Differences {  // weights of the steps from the neighbour before and to the one behind
    double first_before, first_behind, second_before, second_behind;
  };
  static Differences differences(double before, double behind);
  template <class Scalar, class Use>
  void for_each_corner(int plane, const Displacement<Scalar>& displacement, const Use& use) const;
  void find_change(int plane, const Displacement<double>& displacement);
  class RowOfAreas;
  void find_worst_cell(int plane, const Displacement<double>&, EllipticGridSummary&) const;

  OGrid grid_;
  std::vector<Differences> along_rho_;
  std::vector<double> first_before_, first_behind_, second_before_, second_behind_;  // along theta
  SeparableSolver flat_;
  Eigen::VectorXd corners_, change_, before_;  // the inner corners' y, then z
  Eigen::VectorXd r_rho_, r_theta_;            // in the same order
  Eigen::VectorXd weight_;               // of the residual: less than 1 at the edges of the flag
  std::vector<double> part_y_, part_z_;  // of the flag's displacement, where it is too far at once
  Anderson acceleration_;
};

}  // namespace pennon::dns

/// How the corners of the grid follow a small displacement of the flag along z: the elliptic grid
/// (dns/grid/elliptic_grid.hpp), linearised about rest. Antisymmetric as the motion of the flag is:
/// along y odd in z, along z even.
#pragma once

#include <Eigen/Core>
#include <complex>

#include "modes/global/equations/jacobian.hpp"
#include "modes/global/equations/plane_equations.hpp"

namespace pennon::modes::global {

/// The corners that move, those within the outer boundary with 0 <= theta <= pi: numbered along
/// theta, then rho, from the flag's trailing edge. Each has a displacement along y and one along z,
/// and takes one below the flag with it.
class MovingCorners {
 public:
  enum Direction { y_displacement, z_displacement };

  explicit MovingCorners(const Extent& extent) : n_rho_(extent.n_rho), n_theta_(extent.n_theta) {}

  int rows() const { return n_rho_; }
  int columns() const { return n_theta_ / 2 + 1; }
  Eigen::Index unknowns() const { return 2 * Eigen::Index{rows()} * columns(); }
  Eigen::Index index(int direction, int j, int i) const {
    return 2 * (Eigen::Index{j} * columns() + i) + direction;
  }
  /// The index of the displacement along z of a node of the flag, counted from its leading edge.
  Eigen::Index wall_index(int node) const { return index(z_displacement, 0, columns() - 1 - node); }
  /// Whether a corner has no displacement of its own: that along y on the axis z = 0, where it is 0
  /// by symmetry.
  bool is_void(int direction, int i) const {
    return direction == y_displacement && (i == 0 || i == columns() - 1);
  }

  /// Sets the displacement of a corner and, by symmetry, of its mirror image below the flag.
  template <class Scalar>
  void set(Displacement<Scalar>& d, int direction, int j, int i, const Scalar& value) const {
    Field<Scalar>& field = direction == y_displacement ? d.y : d.z;
    const int below = (n_theta_ - i) % n_theta_;
    field.row(0, j)[below] = direction == y_displacement ? -value : value;
    field.row(0, j)[i] = is_void(direction, i) ? Scalar(0) : value;
    field.wrap_theta(0, j, j + 1);
  }

  /// For derivatives by every displacement, by complex steps. None of the equations depends on two
  /// corners that lie `period` rows or columns apart, so that such corners share an evaluation
  /// (Curtis, Powell & Reid 1974): calls evaluate(step) with the displacement of these corners,
  /// then use(direction, j, i) for each of them.
  template <class Evaluate, class Use>
  void for_each_step(int period, const Evaluate& evaluate, const Use& use) const {
    using Complex = std::complex<double>;
    Displacement<Complex> step(Extent{1, n_rho_, n_theta_});
    for (const int direction : {y_displacement, z_displacement})
      for (int row = 0; row < period; ++row)
        for (int column = 0; column < period; ++column) {
          const auto for_each_seed = [&](const auto& seed) {
            for (int j = row; j < rows(); j += period)
              for (int i = column; i < columns(); i += period)
                if (!is_void(direction, i)) seed(j, i);
          };
          const auto move = [&](double by) {
            for_each_seed([&](int j, int i) { set(step, direction, j, i, Complex(0, by)); });
          };
          move(complex_step);
          evaluate(step);
          for_each_seed([&](int j, int i) { use(direction, j, i); });
          move(0);
        }
  }

  /// The displacement of all corners from the unknowns() displacements of the moving ones.
  template <class Scalar>
  Displacement<Scalar> unpack(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& corners) const {
    Displacement<Scalar> d(Extent{1, n_rho_, n_theta_});
    for (int j = 0; j < rows(); ++j)
      for (int i = 0; i < columns(); ++i)
        for (const int direction : {y_displacement, z_displacement})
          set(d, direction, j, i, corners[index(direction, j, i)]);
    return d;
  }

 private:
  int n_rho_, n_theta_;
};

/// G: the displacements of the moving corners (rows) where one of the last `nodes` nodes of the
/// flag alone is displaced, by 1 (a column for each of them).
Eigen::MatrixXd grid_response(const OGrid&, int nodes);

}  // namespace pennon::modes::global

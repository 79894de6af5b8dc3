/// The unknowns of a flow that is symmetric about the plane of the flag, or antisymmetric: those of
/// the upper cells, theta < pi.
///
/// About a flat flag the steady flow is symmetric: v, u and p even in z, w odd. Its linear
/// disturbances are the sum of two families that are not coupled: symmetric ones, in which the flag
/// can only stretch, and antisymmetric ones (v, u and p odd, w even), in which it bends and
/// flutters. Only half of the unknowns are needed for either.
#pragma once

#include <Eigen/Core>

#include "modes/global/equations/plane_equations.hpp"

namespace pennon::modes::global {

enum class Symmetry { symmetric, antisymmetric };

class HalfPlane {
 public:
  /// `components` of the velocity.
  HalfPlane(const Extent& extent, int components, Symmetry symmetry)
      : components_(components),
        n_rho_(extent.n_rho),
        n_theta_(extent.n_theta),
        symmetry_(symmetry) {}

  int fields() const { return components_ + 1; }
  int rows() const { return n_rho_; }
  int columns() const { return n_theta_ / 2; }
  Eigen::Index cells() const { return Eigen::Index{rows()} * columns(); }
  Eigen::Index unknowns() const { return fields() * cells(); }
  /// Unknowns of a cell lie together: v, w, u as the case has them, p.
  Eigen::Index index(int field, int j, int i) const {
    return (Eigen::Index{j} * columns() + i) * fields() + field;
  }

  /// The column below the flag that is the mirror image of column i above it.
  int mirror(int i) const { return n_theta_ - 1 - i; }
  /// The factor, 1 or -1, that takes a field's value above the flag to that of its mirror image.
  double sign_below(int field) const {
    return (static_cast<std::size_t>(field) == dns::along_z) ==
                   (symmetry_ == Symmetry::antisymmetric)
               ? 1
               : -1;
  }

  /// Writes the fields of the whole plane, without ghosts, from unknowns() numbers.
  template <class Scalar>
  void unpack(const Eigen::Matrix<Scalar, Eigen::Dynamic, 1>& unknowns,
              PlaneFlow<Scalar>& q) const {
    for_each([&](int f, int j, int i, Eigen::Index k) {
      Scalar* row = q.field(f).row(0, j);
      row[i] = unknowns[k];
      row[mirror(i)] = sign_below(f) * unknowns[k];
    });
  }
  /// The unknowns() numbers of a flow: its fields in the upper cells.
  template <class Scalar>
  Eigen::Matrix<Scalar, Eigen::Dynamic, 1> pack(const PlaneFlow<Scalar>& q) const {
    Eigen::Matrix<Scalar, Eigen::Dynamic, 1> unknowns(this->unknowns());
    for_each([&](int f, int j, int i, Eigen::Index k) { unknowns[k] = q.field(f).row(0, j)[i]; });
    return unknowns;
  }

  /// use(field, j, i, index) for all unknowns in turn.
  template <class Use>
  void for_each(const Use& use) const {
    Eigen::Index k = 0;
    for (int j = 0; j < rows(); ++j)
      for (int i = 0; i < columns(); ++i)
        for (int f = 0; f < fields(); ++f) use(f, j, i, k++);
  }

 private:
  int components_, n_rho_, n_theta_;
  Symmetry symmetry_;
};

}  // namespace pennon::modes::global

/// A few shapes V of the flag in which its equations are solved by Galerkin's method,
///
///   V^H [lambda^2 mu m + K - F(lambda)] V a = 0,     zeta = V a,     V^H m V = 1.
///
/// K and the samples of F are projected once; what is left has the size of the basis. Where V holds
/// the modes to e and those from the left, psi, to e' the eigenvalue is right to e e': with
/// S(lambda) zeta = 0, psi^H S = 0 exactly, a, b the shares of zeta and psi in V,
///
///   b^H V^H S V a = (V b - psi)^H S (V a - zeta).
///
/// So both belong to it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/map/rational_fit.hpp"

namespace pennon::modes::global {

class FlagBasis {
 public:
  /// The directions in which the shapes, made equally large, lie most: singular vectors in the norm
  /// of the mass, down to `tolerance` of the largest singular value.
  FlagBasis(const Eigen::VectorXd& mass, const std::vector<Eigen::VectorXcd>& shapes,
            double tolerance);

  /// What of a shape does not lie in the basis yet becomes part of it.
  void add(const Eigen::VectorXcd& shape);

  Eigen::Index size() const { return V_.cols(); }
  /// Whether nothing can be added.
  bool is_whole() const { return V_.cols() == V_.rows(); }

  FlagOperator reduced(const FlagOperator&) const;
  Eigen::MatrixXcd reduced(const Eigen::MatrixXcd& F) const { return V_.adjoint() * F * V_; }
  RationalFit reduced(const RationalFit& F) const { return F.projected(V_); }
  /// V a, also where `a` is from before the last shapes were added.
  Eigen::VectorXcd shape(const Eigen::VectorXcd& a) const { return V_.leftCols(a.size()) * a; }

 private:
  Eigen::VectorXd mass_;
  Eigen::MatrixXcd V_;
};

}  // namespace pennon::modes::global

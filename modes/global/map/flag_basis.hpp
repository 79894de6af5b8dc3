/// A few shapes of the flag, the columns of Z, in which its equations are solved by Galerkin's
/// method,
///
///   Z^H [lambda^2 mu m + K - F(lambda)] Z a = 0,     zeta = Z a,     Z^H m Z = 1.
///
/// K and the samples of F are projected once; what is left has the size of the basis. Let
/// S(lambda) zeta = 0 and psi^H S(lambda) = 0 for a mode and its adjoint of the whole flag, and let
/// Z a and Z b be their best approximations in the basis. Then
///
///   b^H Z^H S Z a = (Z b - psi)^H S (Z a - zeta),
///
/// so the error of the eigenvalue is the product of the errors of mode and adjoint, and the basis
/// should hold both.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "modes/global/equations/flag_operator.hpp"
#include "modes/global/map/rational_fit.hpp"

namespace pennon::modes::global {

class FlagBasis {
 public:
  /// The singular vectors, in the norm of the mass, of the shapes scaled to equal norms, down to
  /// `tolerance` of the largest singular value.
  FlagBasis(const Eigen::VectorXd& mass, const std::vector<Eigen::VectorXcd>& shapes,
            double tolerance);

  /// Adds the part of the shape that is orthogonal to the basis; nothing where that is rounding.
  void add(const Eigen::VectorXcd& shape);

  Eigen::Index size() const { return Z_.cols(); }
  /// Whether the basis spans all shapes of the flag, so that nothing can be added.
  bool is_whole() const { return Z_.cols() == Z_.rows(); }

  FlagOperator reduced(const FlagOperator&) const;
  Eigen::MatrixXcd reduced(const Eigen::MatrixXcd& F) const { return Z_.adjoint() * F * Z_; }
  RationalFit reduced(const RationalFit& F) const { return F.projected(Z_); }
  /// Z a. `a` may be shorter than the basis: it then is of the basis before shapes were added.
  Eigen::VectorXcd shape(const Eigen::VectorXcd& a) const { return Z_.leftCols(a.size()) * a; }

 private:
  Eigen::VectorXd mass_;
  Eigen::MatrixXcd Z_;
};

}  // namespace pennon::modes::global

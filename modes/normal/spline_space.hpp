/// Splines of degree 8 on the chord 0 <= y <= 1, with seven continuous derivatives at the knots:
/// the space in which the modes of the flag in vacuum are sought. Eigenvalues converge with the
/// 16th power of the element size where the modes are smooth.
///
/// All numbers have extended precision (`Extended`): the bending energy of a flag's rigid motion
/// must cancel to zero among terms that grow with the inverse cube of the element size.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace pennon::modes {

using Extended = long double;
using ExtendedVector = Eigen::Matrix<Extended, Eigen::Dynamic, 1>;
using ExtendedMatrix = Eigen::Matrix<Extended, Eigen::Dynamic, Eigen::Dynamic>;

class SplineSpace {
 public:
  static constexpr int degree = 8;
  static constexpr int functions_per_element = degree + 1;

  /// `breaks`: the ends of the elements, increasing from 0 to 1.
  explicit SplineSpace(std::vector<double> breaks);

  const std::vector<double>& breaks() const { return breaks_; }
  /// Number of basis functions. At y = 0 only the first is not 0, and only the first two have a
  /// slope; likewise the last at y = 1, where it is 1.
  Eigen::Index size() const { return knots_.size() - degree - 1; }

  /// The functions that are not 0 at y, and their first two derivatives.
  struct Local {
    Eigen::Index first;                                       ///< index of the first of them
    Eigen::Array<Extended, 3, functions_per_element> values;  ///< row: order of the derivative
  };
  Local at(double y) const;

  /// The spline with these coefficients at y.
  double value(const ExtendedVector& coefficients, double y) const;

 private:
  std::vector<double> breaks_;
  Eigen::Array<Extended, 1, Eigen::Dynamic> knots_;
};

}  // namespace pennon::modes

/// The shapes from which direct simulations start (Banerjee, Connell & Yue 2015, 5.1):
///
///   zeta(x, y, 0) = sum over n = 0 to N of
///                   J_n(alpha_n1 (1-y)) (A_n cos(2 pi n x/gamma) + B_n sin(2 pi n x/gamma))
///
/// scaled by L, with alpha_n1 the first positive zero of J_n. In two dimensions only A_0 counts.
#pragma once

#include <optional>
#include <vector>

namespace pennon::modes {

class InitialShape {
 public:
  /// A_0 to A_N, B_0 to B_N; where one list is shorter, the rest of it is 0. Throws InputError
  /// where N is over largest_n.
  InitialShape(std::vector<double> A, std::vector<double> B, std::optional<double> gamma);

  /// zeta at a point, 0 <= y <= 1.
  double operator()(double x, double y) const;
  /// The N of the sum.
  int largest_wave() const { return static_cast<int>(waves_.size()) - 1; }

 private:
  struct Wave {
    double A, B, alpha;
  };
  std::vector<Wave> waves_;
  double base_wavenumber_;  // 2 pi/gamma, 0 in two dimensions
};

}  // namespace pennon::modes

/// A displacement as a sum of normal modes, and back:
///
///   zeta(x, y) = sum over n, m of Y_nm(y) (A_nm cos(k_x x) + B_nm sin(k_x x)),   k_x = 2 pi
///   n/gamma
///
/// The amplitudes of a function are its projections: integrals over 0 <= y <= 1 with the family's
/// weight w, by quadrature on the family's panels, and over one period in x, by the trapezoid rule.
/// The amplitudes of samples solve a least-squares problem in which each sample is weighted by w.
#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "modes/normal/normal_modes.hpp"
#include "modes/normal/samples.hpp"

namespace pennon::modes {

/// zeta(x, y), scaled by L. In two dimensions x is 0.
using Displacement = std::function<double(double x, double y)>;

struct Amplitude {
  int n, m;
  double A, B;  ///< B = 0 for n = 0
};

/// How well the samples determine the amplitudes.
struct Fit {
  std::size_t samples;
  Eigen::Index unknowns;
  double condition_number;  ///< of the least-squares problem, its columns of equal norm in w
};

struct Decomposition {
  std::vector<Amplitude> amplitudes;  ///< in the order of NormalModes::modes
  /// The norm of zeta minus the sum, over the norm of zeta; the norm is the square root of the
  /// integral (for samples the sum) of w zeta^2. 0 for zeta = 0.
  double truncation_error;
  std::optional<Fit> fit;  ///< of samples
};

/// The decomposition of a function. It is exact along the span where zeta has at most `waves` waves
/// in a period.
Decomposition decompose(const NormalModes&, const Displacement&, int waves = 64);

/// The decomposition of samples. `where` names them in messages. Throws InputError if they are
/// fewer than the unknown amplitudes, or lie so that some sum of modes vanishes at all of them.
Decomposition decompose(const NormalModes&, std::span<const Sample>, const std::string& where);

/// The sum at a point, 0 <= y <= 1.
double displacement(const NormalModes&, std::span<const Amplitude>, double x, double y);

}  // namespace pennon::modes

/// Normal modes of a flag without fluid loading (Banerjee, Connell & Yue 2015, appendix C):
///
///   zeta = Y(y) {cos, sin}(k_x x) cos(omega t - epsilon),   k_x = 2 pi n/gamma
///
/// Families differ in what tension and bending they assume; within one, modes of the same n are
/// orthogonal: the integral of w Y_i Y_j over 0 <= y <= 1 is 0 for i != j.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "common/case/parameters.hpp"

namespace pennon::modes {

enum class Family { bessel, hanging_chain, in_vacuo };

/// A function of y, from the leading edge y = 0 to the trailing edge y = 1.
using Profile = std::function<double(double)>;

struct NormalMode {
  int n;                ///< waves along the span
  int m;                ///< number along the chord, from 1
  double k_x;           ///< spanwise wavenumber; 0 in two dimensions
  double alpha;         ///< omega/c with c^2 = 1.3 Re^-1/2/mu; hanging_chain: the zero of J_0
  double omega;         ///< angular frequency, scaled by V/L
  double norm_squared;  ///< integral of w Y^2
  Profile shape;        ///< Y
};

struct NormalModes {
  Family family;
  std::optional<double> gamma;
  Profile weight;                 ///< w
  std::vector<double> panels;     ///< from 0 to 1: gauss_legendre() of them integrates w Y_i Y_j
  std::vector<NormalMode> modes;  ///< by n, then m
};

/// Which modes of a family: all of the given n, m = 1 to `m`.
struct ModeRange {
  std::vector<int> n;
  int m;
};

/// 2 pi n/gamma, 0 in two dimensions.
double spanwise_wavenumber(int n, const FlagParameters&);

}  // namespace pennon::modes

/// A flag that varies along the span against the same flag in two dimensions: (4.10) and (4.11).
///
///   (4.10)   omega_r,3D/omega_r,2D = c_m (mu + c_m2)/(c_m2 (mu + c_m)), where both are unstable;
///            c_m2 is the added mass at k_x = 0. Printed: c_m/c_m2, which holds for mu >> c_m.
///   (4.11a)  P_3D = P_2D + (k_x/k_y)^2 1.3 nu_s Re^-1/2 (mu + c_m)/c_m^2, exact where c_m = c_m2.
///            Printed: without the factor mu + c_m.
///   (4.11b)  omega_i,3D/omega_i,2D = (P_3D/P_2D)^1/2 ~ 1 + (P_3D - P_2D)/(2 P_2D), the same where
///            c_m = c_m2. Printed: 1 - (k_x/k_y)^2 1.3 nu_s Re^-1/2/(c_m P_2D), P_2D as printed
///            below (4.9): -(mu c_m + (mu + c_m) B)/c_m^2.
///
/// This is the paper's theory, which has neither bending nor cross-flow.
#pragma once

#include "lsa/evaluate.hpp"

namespace pennon::lsa {

struct TwoDRatio {
  double frequency_ratio;         ///< (4.10); NaN where one of the two is stable
  double growth_ratio;            ///< of the roots of (4.6); NaN where the flag in 2D is stable
  double P_expansion;             ///< (4.11a)
  double growth_ratio_expansion;  ///< (4.11b); NaN where the flag in 2D is stable
};

/// The ratios in the model's form, consistent or as printed. Throws what solve() throws.
TwoDRatio two_d_ratio(const Point&, const Theory&);

}  // namespace pennon::lsa

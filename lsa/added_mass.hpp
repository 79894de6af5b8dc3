/// The added-mass coefficient c_m = m_a/(rho_f L) of a wave on the flag (appendix B, table 3).
///
///   two_d   2/k_y                    a plane wave on an unbounded sheet (Connell & Yue 2007)
///   wu      pi gamma/4               (B 6), Wu (1961); 2/k_y in two dimensions, where gamma has no
///                                    meaning. It grows without bound as gamma does, and so does
///                                    not tend to its own two-dimensional value.
///   lamb    2/(k_x^2 + k_y^2)^1/2    the wave of any direction on a sheet wetted on both sides
///                                    (Lamb 1932, section 232); two_d at k_x = 0
///   minami  the integral (B 4) for a given mode and pressure: lsa/minami.hpp
///
/// docs/theory/added-mass.md says where each is valid.
#pragma once

#include <cmath>
#include <numbers>

#include "lsa/minami.hpp"
#include "lsa/model.hpp"

namespace pennon::lsa {

/// c_m of a wave by one of the closed forms. Preconditions: k_y > 0; k_x may have any sign.
template <AddedMass kind>
requires(kind != AddedMass::minami) double closed_form_added_mass(double k_x, double k_y) {
  if constexpr (kind == AddedMass::two_d) return 2 / k_y;
  if constexpr (kind == AddedMass::lamb) return 2 / std::sqrt(k_x * k_x + k_y * k_y);
  if constexpr (kind == AddedMass::wu) {
    constexpr double wu_times_k_x = std::numbers::pi * std::numbers::pi / 2;  // gamma = 2 pi/k_x
    const bool is_two_d = k_x == 0;
    return (is_two_d ? 2.0 : wu_times_k_x) / (is_two_d ? k_y : std::abs(k_x));
  }
}

/// c_m of a wave. Precondition: k_y > 0. Throws SolverError where the quadrature of `minami` fails.
double added_mass(AddedMass kind, const MinamiSettings&, double k_x, double k_y);

}  // namespace pennon::lsa

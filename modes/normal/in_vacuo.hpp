/// The normal modes of the flag in vacuum, with its own bending and a chosen tension.
///
/// Tension of the flag, T_0 = 1.3 Re^-1/2 (0 without a stream), chordwise T, spanwise T_x:
///
///   blasius   T = T_0 (1 - sqrt(y)), T_x = nu_s T   the drag of both layers downstream of y
///   linear    T = T_0 (1-y), T_x = nu_s T_0         without bending: hanging_chain.hpp
///   constant  T = T_0, T_x = nu_s T_0               without bending: a string
///   wedge     T = T_0 s, T_x k_x^2 = T_0 n^2/s, mass mu s, s = 1-y
///                                                   without bending: bessel.hpp; held at both
///                                                   edges for n >= 1
///
/// `blasius` is the consistent form of Banerjee, Connell & Yue (2015, above 4.1), who print
/// sqrt(y). The modes are solved for as in chordwise_problem.hpp and scaled so that the integral of
/// w Y^2 is 1 and Y > 0 at the trailing edge or where it first moves upstream of it. 200 elements
/// give the first 20 frequencies to 1e-11 or better at all but extreme parameters; where fewer
/// elements would change omega^2 by more than 1e-9 of itself, the modes are refused.
#pragma once

#include "modes/normal/chordwise_problem.hpp"
#include "modes/normal/normal_modes.hpp"

namespace pennon::modes {

enum class TensionProfile { blasius, linear, constant, wedge };

/// Twenty modes take seconds, this many a minute or two: the cost grows with the third power.
inline constexpr int most_modes_in_vacuo = 200;

/// The problem of the modes with n waves along the span.
ChordwiseProblem chordwise_problem(TensionProfile, int n, double T_0, const FlagParameters&);

/// The space of splines on `elements` elements that suits the problem, whose edge layers may be
/// short: sqrt(K_B/T) at y = 0, (K_B/T)^(1/3) at y = 1 where T falls to zero, 1/k_x, and at the
/// square root in `blasius`.
SplineSpace spline_space(TensionProfile, int elements, int n, double T_0, const FlagParameters&);

/// Precondition: mu > 0. alpha is NaN without a stream. Throws InputError where neither tension nor
/// bending holds the flag, or `elements` are fewer than 2 m; SolverError where the elements are too
/// few or lowest_eigenpairs() fails; Interrupted between two n.
NormalModes in_vacuo_modes(const ModeRange&, const FlagParameters&, const FlowParameters&,
                           TensionProfile, int elements);

}  // namespace pennon::modes

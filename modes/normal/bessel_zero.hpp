/// alpha_nm, the m-th positive zero of the Bessel function J_n (Banerjee, Connell & Yue 2015, C 5).
///
/// GSL gives each zero to 5e-9 relative at worst (measured for n <= 200, m <= 1000: near m = 5 for
/// n >= 5, where it joins two expansions). Newton's method on the C library's J_n takes it to half
/// a unit of the last place; neighbouring zeros are at least 3 apart, so a correction of less than
/// `largest_correction` cannot lead to another one.
#pragma once

namespace pennon::modes {

inline constexpr int largest_n = 200;   ///< of n
inline constexpr int largest_m = 1000;  ///< of m

/// alpha_nm for 0 <= n <= largest_n and 1 <= m <= largest_m, to 2e-16 relative. Throws InputError
/// for other n and m, SolverError where GSL's zero is not near one of J_n.
double bessel_zero(int n, int m);

/// J_n(x) for n >= 0 by the C library. Near its zeros it is more accurate than GSL's; where it
/// underflows it is 0, which GSL reports as an error.
double bessel_j(int n, double x);

}  // namespace pennon::modes

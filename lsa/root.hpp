/// Roots and maxima of a function of one variable, by GSL.
#pragma once

#include <functional>

namespace pennon::lsa {

/// The root in [a, b], where f(a) and f(b) differ in sign (or one is 0), by Brent's method: to the
/// last bits of its argument, or where the sign changes if f jumps. Throws what f throws.
double find_root(const std::function<double(double)>& f, double a, double b);

/// The place of the maximum in [a, b], where f(inside) is at least f(a) and f(b), by Brent's
/// minimiser: to about 1e-8 relative, as far as values can tell. Throws what f throws.
double find_maximum(const std::function<double(double)>& f, double a, double inside, double b);

}  // namespace pennon::lsa
